// SPDX-License-Identifier: BSD-3-Clause
// Of a still picture line art makes the strokes that are seen, as dense as all of them, and leaves the inner
// side of closed meshes out.
#include "StyleData.h"

#include "vtkInkLineArtStyle.h"
#include "vtkInkStrokeMapper.h"

#include "vtkAppendPolyData.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkParametricFunctionSource.h"
#include "vtkParametricTorus.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkTriangleFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

vtkSmartPointer<vtkPolyData> MakeTorus()
{
  vtkNew<vtkParametricTorus> torus;
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(torus);
  source->SetUResolution(60);
  source->SetVResolution(40);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(source->GetOutputPort());
  triangles->Update();
  return triangles->GetOutput();
}

/// One that looks down at a square around (center, center).
/// @param size half of that of the frame, which is all of the data
vtkInkStyle::StillCamera MakeCamera(double size, double center, double half)
{
  return [=](vtkPoints* frame)
  {
    EXPECT_NEAR(frame->GetBounds()[1], size, 0.01);
    auto camera = vtkSmartPointer<vtkCamera>::New();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(half);
    camera->SetPosition(center, center, 9.0);
    camera->SetFocalPoint(center, center, 0.0);
    camera->SetExplicitAspectRatio(1.0);
    return camera;
  };
}

/// Those that strokes go through.
vtkSmartPointer<vtkPoints> GetStrokePoints(vtkInkStyle* style)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  vtkPolyData* strokes = style->GetPiece(1);
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (strokes->GetLines()->InitTraversal(); strokes->GetLines()->GetNextCell(count, ids);)
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      points->InsertNextPoint(strokes->GetPoint(ids[i]));
    }
  }
  return points;
}

vtkIdType CountUpperPoints(vtkPoints* points)
{
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    count += points->GetPoint(i)[2] > 0.0;
  }
  return count;
}

} // namespace

TEST(LineArtStyle, StrokesOfWhatAStillPictureShows)
{
  constexpr double edge = 0.25; // of the torus's triangles, and more
  const vtkSmartPointer<vtkPolyData> torus = MakeTorus();
  vtkNew<vtkInkLineArtStyle> style;
  ASSERT_TRUE(style->SetParameter("LineSpacing", 8));
  ASSERT_TRUE(style->Make(torus));
  const vtkSmartPointer<vtkPoints> all = GetStrokePoints(style);
  const vtkIdType surface = style->GetPiece(0)->GetNumberOfPoints();

  // Both halves of the torus's tube that face up, and what lies within 8 spacings, or .19, of their outlines:
  // up to 52 degrees down.
  style->SetStillCamera(MakeCamera(1.5, 0.0, 1.5));
  ASSERT_TRUE(style->Make(torus));
  const vtkSmartPointer<vtkPoints> facing = GetStrokePoints(style);
  const auto share = [](vtkIdType part, vtkIdType whole)
  { return static_cast<double>(part) / static_cast<double>(whole); };
  EXPECT_NEAR(share(facing->GetNumberOfPoints(), all->GetNumberOfPoints()), 0.5 + 52.0 / 180.0, 0.06);
  EXPECT_GT(facing->GetBounds()[4], -0.39 - 0.1);
  // As dense as all of them.
  EXPECT_NEAR(share(CountUpperPoints(facing), CountUpperPoints(all)), 1.0, 0.05);

  // A quarter of it from near: with a tenth around, of what it shows.
  style->SetStillCamera(MakeCamera(1.5, 0.75, 0.75 / 1.2));
  ASSERT_TRUE(style->Make(torus));
  const vtkSmartPointer<vtkPoints> near = GetStrokePoints(style);
  const double* bounds = near->GetBounds();
  EXPECT_GT(std::min(bounds[0], bounds[2]), -edge);
  EXPECT_GT(std::min(bounds[1], bounds[3]), 1.45);
  EXPECT_NEAR(share(near->GetNumberOfPoints(), facing->GetNumberOfPoints()), 0.25, 0.06);
  // What hides strokes and has contours is all there.
  EXPECT_EQ(style->GetPiece(0)->GetNumberOfPoints(), surface);

  style->SetStillCamera(nullptr);
  ASSERT_TRUE(style->Make(torus));
  EXPECT_EQ(GetStrokePoints(style)->GetNumberOfPoints(), all->GetNumberOfPoints());
}

TEST(LineArtStyle, NoStrokesWhereNothingIsSeen)
{
  // A sphere in a closed box.
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(40);
  sphere->SetRadius(0.8);
  vtkNew<vtkCubeSource> box;
  box->SetXLength(4.0);
  box->SetYLength(4.0);
  box->SetZLength(4.0);
  vtkNew<vtkAppendPolyData> both;
  both->AddInputConnection(sphere->GetOutputPort());
  both->AddInputConnection(box->GetOutputPort());
  both->Update();
  vtkNew<vtkInkLineArtStyle> style;
  ASSERT_TRUE(style->SetParameter("LineSpacing", 12));
  const auto nearest = [&]
  {
    EXPECT_TRUE(style->Make(both->GetOutput()));
    double least = 9.0;
    const vtkSmartPointer<vtkPoints> points = GetStrokePoints(style);
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      least = std::min(least, vtkMath::Norm(points->GetPoint(i)));
    }
    return least;
  };
  EXPECT_LT(nearest(), 0.9);
  style->SetStillCamera(MakeCamera(2.0, 0.0, 2.1));
  EXPECT_GT(nearest(), 1.9);
}

TEST(LineArtStyle, InnerSidesOfClosedMeshesHaveNoStrokes)
{
  vtkNew<vtkInkLineArtStyle> style;
  ASSERT_TRUE(style->SetParameter("LineSpacing", 12));
  ASSERT_TRUE(style->Draw(MakeTorus()));
  EXPECT_EQ(style->GetStrokeMapper()->GetCullingCosine(), 0.2);
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(20, 20);
  plane->Update();
  ASSERT_TRUE(style->Draw(plane->GetOutput()));
  EXPECT_EQ(style->GetStrokeMapper()->GetCullingCosine(), 1.0);
}

TEST(LineArtStyle, SurfacesOfImagesThatAreSeenFromWithinHaveStrokes)
{
  // As a level set that is negative inside, or a hole in something dense.
  const vtkSmartPointer<vtkImageData> ball = MakeBall();
  vtkNew<vtkInkLineArtStyle> style;
  ASSERT_TRUE(style->SetParameter("LineSpacing", 12));
  style->SetParameterAsString("IsoValues", "100");
  ASSERT_TRUE(style->Draw(ball));
  EXPECT_EQ(style->GetStrokeMapper()->GetCullingCosine(), 0.2);
  vtkDataArray* values = ball->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetComponent(i, 0, 200.0 - values->GetComponent(i, 0));
  }
  values->Modified();
  ball->Modified();
  style->SetParameterAsString("IsoValues", "100");
  ASSERT_TRUE(style->Draw(ball));
  EXPECT_EQ(style->GetStrokeMapper()->GetCullingCosine(), 1.0);
}
