// SPDX-License-Identifier: BSD-3-Clause
// Normals of each side of sharp edges: of meshes without and with mean normals, of strips and polygons.

#include "InkFeatureNormals.h"
#include "InkTestWeldedBox.h"

#include "vtkCellArray.h"
#include "vtkCylinderSource.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkTriangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{

/// The least cosine between the normal of a polygon and those of its points.
double LeastLikeness(vtkPolyData* mesh)
{
  double least = 1.0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, corners);
    double p[3][3];
    for (int i = 0; i < 3; ++i)
    {
      mesh->GetPoint(corners->GetId(i), p[i]);
    }
    double normal[3];
    vtkTriangle::ComputeNormal(p[0], p[1], p[2], normal);
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      const double* own = mesh->GetPointData()->GetNormals()->GetTuple3(corners->GetId(i));
      least = std::min(least, normal[0] * own[0] + normal[1] * own[1] + normal[2] * own[2]);
    }
  }
  return least;
}

} // namespace

TEST(FeatureNormals, BoxesHaveANormalForEachSide)
{
  const vtkSmartPointer<vtkPolyData> box = InkTestWeldedBox();
  ASSERT_EQ(box->GetNumberOfPoints(), 8);
  const vtkSmartPointer<vtkPolyData> split = InkWithFeatureNormals(box);
  EXPECT_EQ(box->GetNumberOfPoints(), 8);
  EXPECT_EQ(split->GetNumberOfPoints(), 24);
  EXPECT_EQ(split->GetNumberOfPolys(), 6);
  EXPECT_GT(LeastLikeness(split), 1.0 - 1e-6);
  EXPECT_TRUE(InkHasFeatureEdges(split));
  for (vtkIdType i = 0; i < split->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(split->GetPointData()->GetArray("Heat")->GetTuple1(i), split->GetPoint(i)[0]);
  }
  // As it is, a second time.
  EXPECT_EQ(InkWithFeatureNormals(split), split);
}

TEST(FeatureNormals, NormalsThatAreMeansOverEdgesAreReplaced)
{
  const vtkSmartPointer<vtkPolyData> box = InkTestWeldedBox();
  InkTestAddMeanNormals(box);
  EXPECT_GT(LeastLikeness(InkWithFeatureNormals(box)), 1.0 - 1e-6);
}

TEST(FeatureNormals, ArraysAreThoseOfAllPoints)
{
  const vtkSmartPointer<vtkPolyData> box = InkTestWeldedBox();
  InkTestAddMeanNormals(box);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("Ids");
  for (vtkIdType i = 0; i < 8; ++i)
  {
    ids->InsertNextValue(i);
  }
  box->GetPointData()->SetGlobalIds(ids);
  const vtkSmartPointer<vtkPolyData> split = InkWithFeatureNormals(box);
  vtkPointData* data = split->GetPointData();
  EXPECT_EQ(data->GetGlobalIds(), nullptr);
  ASSERT_EQ(data->GetNumberOfArrays(), 3) << "with the points that they were made of";
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    EXPECT_EQ(data->GetAbstractArray(i)->GetNumberOfTuples(), 24) << data->GetArrayName(i);
  }
}

TEST(FeatureNormals, SmoothMeshesKeepTheirs)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetThetaResolution(40);
  ball->SetPhiResolution(30);
  ball->Update();
  vtkPolyData* mesh = ball->GetOutput();
  EXPECT_EQ(InkWithFeatureNormals(mesh), mesh);
  EXPECT_FALSE(InkHasFeatureEdges(mesh));
  vtkNew<vtkSphereSource> coarse; // with 45 degrees between its sides
  coarse->Update();
  EXPECT_EQ(InkWithFeatureNormals(coarse->GetOutput()), coarse->GetOutput());
  mesh->GetPointData()->SetNormals(nullptr);
  mesh->GetPointData()->RemoveArray("Normals");
  const vtkSmartPointer<vtkPolyData> found = InkWithFeatureNormals(mesh);
  EXPECT_EQ(found->GetNumberOfPoints(), mesh->GetNumberOfPoints());
  EXPECT_GT(LeastLikeness(found), 0.99);
  EXPECT_FALSE(InkHasFeatureEdges(found));
}

TEST(FeatureNormals, StripsAndPolygonsOfManyCorners)
{
  // A cylinder's side and caps of 24 corners, welded; and a strip of two faces of a roof.
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetResolution(24);
  const vtkSmartPointer<vtkPolyData> drum = InkWithFeatureNormals(InkTestWelded(cylinder));
  EXPECT_EQ(drum->GetNumberOfPoints(), 96);
  EXPECT_EQ(drum->GetNumberOfPolys(), 26);
  EXPECT_GT(LeastLikeness(drum), std::cos(0.14)); // half of the 15 degrees of a side

  vtkNew<vtkPolyData> roof;
  vtkNew<vtkPoints> points;
  for (const double x : { -1.0, 0.0, 1.0 })
  {
    points->InsertNextPoint(x, 0.0, 1.0 - std::abs(x));
    points->InsertNextPoint(x, 3.0, 1.0 - std::abs(x));
  }
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 1, 2, 3, 4, 5 });
  roof->SetPoints(points);
  roof->SetStrips(strips);
  const vtkSmartPointer<vtkPolyData> split = InkWithFeatureNormals(roof);
  EXPECT_EQ(split->GetNumberOfPoints(), 8);
  EXPECT_EQ(split->GetNumberOfPolys(), 4);
  EXPECT_GT(LeastLikeness(split), 1.0 - 1e-6);
}

TEST(FeatureNormals, ManyPleatsMeetAtAPoint)
{
  constexpr int pleats = 40;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.5);
  vtkNew<vtkCellArray> triangles;
  for (int i = 0; i < pleats; ++i)
  {
    const double angle = 6.283185307179586 * i / pleats;
    points->InsertNextPoint(std::cos(angle), std::sin(angle), i % 2 == 0 ? 0.15 : -0.15);
    triangles->InsertNextCell({ 0, 1 + i, 1 + (i + 1) % pleats });
  }
  vtkNew<vtkPolyData> fan;
  fan->SetPoints(points);
  fan->SetPolys(triangles);
  const vtkSmartPointer<vtkPolyData> split = InkWithFeatureNormals(fan);
  EXPECT_EQ(split->GetNumberOfPoints(), 3 * pleats) << "each triangle for itself";
  EXPECT_GT(LeastLikeness(split), 1.0 - 1e-6);
  for (vtkIdType i = 0; i < split->GetNumberOfPolys(); ++i)
  {
    vtkIdType size;
    const vtkIdType* before;
    fan->GetPolys()->GetCellAtId(i, size, before);
    const std::array<vtkIdType, 3> given{ before[0], before[1], before[2] };
    const vtkIdType* after;
    split->GetPolys()->GetCellAtId(i, size, after);
    for (std::size_t k = 0; k < 3; ++k)
    {
      double p[3];
      double q[3];
      fan->GetPoint(given[k], p);
      split->GetPoint(after[k], q);
      EXPECT_EQ(std::equal(p, p + 3, q), true) << i;
    }
  }
}
