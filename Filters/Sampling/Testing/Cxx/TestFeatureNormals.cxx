// SPDX-License-Identifier: BSD-3-Clause
// Normals of each side of sharp edges: of samples, of meshes with mean normals, of strips and polygons.

#include "InkFeatureNormals.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCleanPolyData.h"
#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInkStippleGenerator.h"
#include "vtkInkSurfaceSampler.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSphereSource.h"
#include "vtkTriangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

/// A source's polygons, without its normals, with one point at each position.
vtkSmartPointer<vtkPolyData> Welded(vtkPolyDataAlgorithm* source)
{
  source->Update();
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(source->GetOutput()->GetPoints());
  bare->SetPolys(source->GetOutput()->GetPolys());
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(bare);
  clean->Update();
  return clean->GetOutput();
}

/// Eight points, six quads, a value at each point.
vtkSmartPointer<vtkPolyData> WeldedBox()
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(3.0);
  cube->SetYLength(2.0);
  vtkSmartPointer<vtkPolyData> box = Welded(cube);
  vtkNew<vtkDoubleArray> heat;
  heat->SetName("Heat");
  for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
  {
    heat->InsertNextValue(box->GetPoint(i)[0]);
  }
  box->GetPointData()->SetScalars(heat);
  return box;
}

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

TEST(SurfaceSamplerFeatures, BoxesHaveANormalForEachSide)
{
  const vtkSmartPointer<vtkPolyData> box = WeldedBox();
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

namespace
{

/// Normals at the corners of a box that are the means of three faces.
void AddMeans(vtkPolyData* box)
{
  vtkNew<vtkDoubleArray> means;
  means->SetName("Normals");
  means->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < 8; ++i)
  {
    double p[3];
    box->GetPoint(i, p);
    const double length = std::sqrt(3.0);
    means->InsertNextTuple3(std::copysign(1.0, p[0]) / length, std::copysign(1.0, p[1]) / length,
      std::copysign(1.0, p[2]) / length);
  }
  box->GetPointData()->SetNormals(means);
}

} // namespace

TEST(SurfaceSamplerFeatures, NormalsThatAreMeansOverEdgesAreReplaced)
{
  const vtkSmartPointer<vtkPolyData> box = WeldedBox();
  AddMeans(box);
  EXPECT_GT(LeastLikeness(InkWithFeatureNormals(box)), 1.0 - 1e-6);
}

TEST(SurfaceSamplerFeatures, ArraysAreThoseOfAllPoints)
{
  const vtkSmartPointer<vtkPolyData> box = WeldedBox();
  AddMeans(box);
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
  ASSERT_EQ(data->GetNumberOfArrays(), 2);
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    EXPECT_EQ(data->GetAbstractArray(i)->GetNumberOfTuples(), 24) << data->GetArrayName(i);
  }
}

TEST(SurfaceSamplerFeatures, StipplesHaveTheColorsOfSplitMeshes)
{
  const vtkSmartPointer<vtkPolyData> box = WeldedBox();
  AddMeans(box);
  vtkNew<vtkInkStippleGenerator> generator;
  generator->SetInputData(box);
  generator->SetNumberOfSurfaceStipples(500);
  generator->PassScalarsOn();
  for (const char* name : { "Heat", "" })
  {
    generator->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
    generator->Update();
    vtkPolyData* stipples = generator->GetOutput();
    ASSERT_GT(stipples->GetNumberOfCells(), 0) << name;
    vtkDataArray* heat = stipples->GetCellData()->GetArray("Heat");
    ASSERT_TRUE(heat) << name;
    EXPECT_EQ(heat->GetNumberOfTuples(), stipples->GetNumberOfCells());
  }
}

TEST(SurfaceSamplerFeatures, SmoothMeshesKeepTheirs)
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

TEST(SurfaceSamplerFeatures, StripsAndPolygonsOfManyCorners)
{
  // A cylinder's side and caps of 24 corners, welded; and a strip of two faces of a roof.
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetResolution(24);
  const vtkSmartPointer<vtkPolyData> drum = InkWithFeatureNormals(Welded(cylinder));
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

TEST(SurfaceSamplerFeatures, SamplesFaceOneSide)
{
  vtkNew<vtkInkSurfaceSampler> sampler;
  sampler->SetInputData(WeldedBox());
  sampler->SetNumberOfSamples(2000);
  const auto worst = [&]
  {
    sampler->Update();
    double least = 1.0;
    vtkDataArray* normals = sampler->GetOutput()->GetPointData()->GetNormals();
    for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
    {
      const double* n = normals->GetTuple3(i);
      least = std::min(least, std::max({ std::abs(n[0]), std::abs(n[1]), std::abs(n[2]) }));
    }
    return least;
  };
  EXPECT_GT(worst(), 1.0 - 1e-6);
  // Samples that are to follow a mesh keep its points, and so the means over its edges.
  sampler->KeepFacesOn();
  EXPECT_LT(worst(), 0.7);
}
