// SPDX-License-Identifier: BSD-3-Clause
// Coarse meshes as the smooth surfaces that their normals describe, in all styles, with their arrays.

#include "InkCurvedMesh.h"
#include "InkFeatureNormals.h"
#include "InkSourcePoints.h"
#include "StyleData.h"
#include "StyleErrors.h"
#include "vtkInkContoursStyle.h"
#include "vtkInkIllustrationStyle.h"
#include "vtkInkLineArtStyle.h"
#include "vtkInkSplattingLinesStyle.h"
#include "vtkInkStippleStyle.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCleanPolyData.h"
#include "vtkCubeSource.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace
{

vtkSmartPointer<vtkPolyData> MakeSphere(int resolution, bool normals)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution);
  sphere->SetRadius(1.0);
  sphere->Update();
  vtkSmartPointer<vtkPolyData> mesh = sphere->GetOutput();
  if (!normals)
  {
    mesh->GetPointData()->Initialize();
  }
  return mesh;
}

double LeastRadius(vtkPolyData* points)
{
  double least = 2.0;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    least = std::min(least, vtkMath::Norm(points->GetPoint(i)));
  }
  return least;
}

} // namespace

TEST(CurvedMeshes, PointsAreOnTheSphereWithArraysInterpolated)
{
  const auto mesh = MakeSphere(12, true);
  vtkNew<vtkFloatArray> heights;
  heights->SetName("height");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    heights->InsertNextValue(static_cast<float>(mesh->GetPoint(i)[2]));
  }
  mesh->GetPointData()->AddArray(heights);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("ids");
  vtkNew<vtkIdTypeArray> cells;
  cells->SetName("cells");
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    ids->InsertNextValue(i);
    cells->InsertNextValue(i);
  }
  mesh->GetCellData()->AddArray(cells);
  mesh->GetCellData()->SetGlobalIds(ids);
  const vtkSmartPointer<vtkPolyData> curved = InkCurvedMesh(mesh);
  ASSERT_GT(curved->GetNumberOfCells(), 10 * mesh->GetNumberOfCells());
  EXPECT_GT(LeastRadius(curved), 1.0 - 1e-6);
  // A cell's parts would not be told apart.
  EXPECT_EQ(curved->GetCellData()->GetGlobalIds(), nullptr);
  vtkDataArray* source = curved->GetCellData()->GetArray("cells");
  vtkDataArray* height = curved->GetPointData()->GetArray("height");
  ASSERT_TRUE(source && height && curved->GetPointData()->GetNormals());
  EXPECT_EQ(source->GetNumberOfTuples(), curved->GetNumberOfCells());
  EXPECT_EQ(source->GetRange()[1], mesh->GetNumberOfCells() - 1);
  for (vtkIdType i = 0; i < curved->GetNumberOfPoints(); ++i)
  {
    // Linear between the mesh's points, which are 30 degrees apart.
    EXPECT_NEAR(height->GetTuple1(i), curved->GetPoint(i)[2], 0.06);
    EXPECT_NEAR(
      vtkMath::Dot(curved->GetPoint(i), curved->GetPointData()->GetNormals()->GetTuple(i)), 1.0, 1e-5);
  }
  EXPECT_EQ(InkCurvedMesh(curved), curved);
}

TEST(CurvedMeshes, FurtherPointsKnowAPointOfTheMeshNearby)
{
  // Edges of 26 degrees at most, whose halves are divided again.
  const auto mesh = MakeSphere(15, true);
  const vtkSmartPointer<vtkPolyData> curved = InkCurvedMesh(mesh);
  vtkIdTypeArray* sources = InkGetSourcePoints(curved);
  ASSERT_NE(sources, nullptr);
  for (vtkIdType i = 0; i < curved->GetNumberOfPoints(); ++i)
  {
    if (i < mesh->GetNumberOfPoints())
    {
      EXPECT_EQ(sources->GetValue(i), i);
    }
    EXPECT_GT(vtkMath::Dot(curved->GetPoint(i), mesh->GetPoint(sources->GetValue(i))), std::cos(0.35)) << i;
  }
  EXPECT_EQ(InkGetSourcePoints(mesh), nullptr);
}

TEST(CurvedMeshes, SidesOfACubesCornersKnowTheCorner)
{
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(cube->GetOutputPort());
  clean->Update();
  vtkPolyData* mesh = clean->GetOutput();
  mesh->GetPointData()->Initialize();
  const vtkSmartPointer<vtkPolyData> split = InkWithFeatureNormals(mesh);
  vtkIdTypeArray* sources = InkGetSourcePoints(split);
  ASSERT_EQ(split->GetNumberOfPoints(), 24);
  ASSERT_NE(sources, nullptr);
  for (vtkIdType i = 0; i < 24; ++i)
  {
    EXPECT_EQ(vtkMath::Distance2BetweenPoints(split->GetPoint(i), mesh->GetPoint(sources->GetValue(i))), 0.0);
  }
}

/// A point in the middle of an edge has none of them.
TEST(CurvedMeshes, IdsOfPointsAreLeftOut)
{
  const auto mesh = MakeSphere(12, true);
  vtkNew<vtkFloatArray> heights;
  heights->SetName("height");
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("ids");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    heights->InsertNextValue(static_cast<float>(mesh->GetPoint(i)[2]));
    ids->InsertNextValue(i);
  }
  for (const int attribute : { vtkDataSetAttributes::PEDIGREEIDS, vtkDataSetAttributes::GLOBALIDS })
  {
    vtkNew<vtkPolyData> copy;
    copy->ShallowCopy(mesh);
    copy->GetPointData()->SetAttribute(ids, attribute);
    copy->GetPointData()->AddArray(heights);
    const vtkSmartPointer<vtkPolyData> curved = InkCurvedMesh(copy);
    ASSERT_GT(curved->GetNumberOfPoints(), mesh->GetNumberOfPoints());
    EXPECT_EQ(curved->GetPointData()->GetAbstractAttribute(attribute), nullptr);
    ASSERT_TRUE(curved->GetPointData()->GetArray("height"));
    EXPECT_EQ(curved->GetPointData()->GetArray("height")->GetNumberOfTuples(), curved->GetNumberOfPoints());
  }
}

/// A point that no polygon has does not count in how long edges are.
TEST(CurvedMeshes, StrayPointsDoNotCount)
{
  const auto mesh = MakeSphere(12, true);
  const vtkIdType expected = InkCurvedMesh(mesh)->GetNumberOfCells();
  vtkNew<vtkPolyData> stray;
  stray->DeepCopy(mesh);
  stray->GetPoints()->InsertNextPoint(1e6, 0.0, 0.0);
  const float up[3]{ 0.0f, 0.0f, 1.0f };
  stray->GetPointData()->GetNormals()->InsertNextTuple(up);
  EXPECT_EQ(InkCurvedMesh(stray)->GetNumberOfCells(), expected);
}

/// All processes have to come to the same step: what is wrong with a mesh is said where it is drawn.
TEST(CurvedMeshes, BrokenMeshesAreTakenAsTheyAre)
{
  const auto mesh = MakeSphere(12, true);
  vtkNew<vtkPolyData> broken;
  broken->DeepCopy(mesh);
  broken->GetPolys()->InsertNextCell({ 0, 1, mesh->GetNumberOfPoints() + 5 });
  vtkNew<vtkInkContoursStyle> style;
  const auto messagesOf = [&](int curved)
  {
    style->SetParameter("CurvedMeshes", curved);
    const StyleErrors errors(style);
    EXPECT_FALSE(style->Make(broken));
    return errors.All;
  };
  EXPECT_EQ(messagesOf(1), messagesOf(0));
}

TEST(CurvedMeshes, StylesDrawThemUnlessSwitchedOff)
{
  const auto mesh = MakeSphere(16, true);
  // Middles of faces are as far inside.
  const double inside = std::cos(vtkMath::Pi() / 16.0);
  const auto check = [&](vtkInkStyle* style)
  {
    SCOPED_TRACE(style->GetLabel());
    MakeFewMarks(style, 20000);
    ASSERT_TRUE(style->GetCurvedMeshes());
    ASSERT_TRUE(style->Make(mesh));
    EXPECT_GT(LeastRadius(style->GetPiece(0)), 1.0 - 1e-3);
    style->SetParameter("CurvedMeshes", 0);
    ASSERT_TRUE(style->Make(mesh));
    EXPECT_LE(style->GetPiece(0)->GetNumberOfPoints() > mesh->GetNumberOfPoints()
        ? LeastRadius(style->GetPiece(0))
        : inside,
      inside + 1e-3);
  };
  check(vtkNew<vtkInkContoursStyle>());
  check(vtkNew<vtkInkLineArtStyle>());
  check(vtkNew<vtkInkStippleStyle>());
  check(vtkNew<vtkInkSplattingLinesStyle>());
  check(vtkNew<vtkInkIllustrationStyle>());
}

TEST(CurvedMeshes, MissingNormalsAreNotedOnce)
{
  vtkNew<vtkInkContoursStyle> style;
  ASSERT_TRUE(style->Make(MakeSphere(16, false)));
  ASSERT_EQ(style->GetNumberOfNotes(), 1);
  EXPECT_NE(std::string(style->GetNote(0)).find("no normals"), std::string::npos);
}
