// SPDX-License-Identifier: BSD-3-Clause
// Of a still picture from near line art makes the strokes that are seen, as dense as all of them, and leaves
// the inner side of closed meshes out.
#include "vtkInkLineArtStyle.h"
#include "vtkInkStrokeMapper.h"

#include "vtkNew.h"
#include "vtkParametricFunctionSource.h"
#include "vtkParametricTorus.h"
#include "vtkPlaneSource.h"
#include "vtkPlanes.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

#include <gtest/gtest.h>

#include <algorithm>

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

} // namespace

TEST(LineArtStyle, StrokesOfWhatAStillPictureShows)
{
  constexpr double margin = 0.25; // an edge of the torus's triangles, and more
  const vtkSmartPointer<vtkPolyData> torus = MakeTorus();
  vtkNew<vtkInkLineArtStyle> style;
  ASSERT_TRUE(style->SetParameter("LineSpacing", 12));
  ASSERT_TRUE(style->Make(torus));
  const auto all = static_cast<double>(style->GetPiece(1)->GetNumberOfPoints());
  const vtkIdType surface = style->GetPiece(0)->GetNumberOfPoints();
  style->SetSeenRegion(
    [&](vtkPoints* frame)
    {
      double bounds[6];
      frame->GetBounds(bounds);
      EXPECT_NEAR(bounds[1], 1.5, 0.01) << "the frame is all of the torus";
      auto region = vtkSmartPointer<vtkPlanes>::New();
      region->SetBounds(0.0, 9.0, 0.0, 9.0, -9.0, 9.0);
      return region;
    });
  ASSERT_TRUE(style->Make(torus));
  vtkPolyData* strokes = style->GetPiece(1);
  double bounds[6];
  strokes->GetBounds(bounds);
  EXPECT_GT(std::min(bounds[0], bounds[2]), -margin);
  EXPECT_GT(std::min(bounds[1], bounds[3]), 1.45);
  EXPECT_NEAR(static_cast<double>(strokes->GetNumberOfPoints()) / all, 0.25, 0.06);
  // What hides strokes and has contours is all there.
  EXPECT_EQ(style->GetPiece(0)->GetNumberOfPoints(), surface);
  style->SetSeenRegion(nullptr);
  ASSERT_TRUE(style->Make(torus));
  EXPECT_EQ(static_cast<double>(style->GetPiece(1)->GetNumberOfPoints()), all);
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
