// SPDX-License-Identifier: BSD-3-Clause
// Which lines analytic shapes have: contours, outer and inner, solid and thin, and nothing between them.
#include "InkTestImage.h"
#include "InkTestPoints.h"
#include "SplattingLinesScene.h"

#include "vtkMath.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

/// Whether there is ink within some pixels of each of 360 points on a circle.
int CountGaps(const InkTestImage& image, double centerX, double centerY, double radius, int reach)
{
  int gaps = 0;
  for (int degree = 0; degree < 360; ++degree)
  {
    const double angle = vtkMath::RadiansFromDegrees(double(degree));
    const int x = static_cast<int>(centerX + radius * std::cos(angle));
    const int y = static_cast<int>(centerY + radius * std::sin(angle));
    gaps += image.CountDark(x - reach, y - reach, x + reach + 1, y + reach + 1) == 0;
  }
  return gaps;
}

/// Ink farther than some pixels from the circle.
int CountStray(const InkTestImage& image, double centerX, double centerY, double radius, double reach)
{
  int stray = 0;
  for (int y = 0; y < image.GetHeight(); ++y)
  {
    for (int x = 0; x < image.GetWidth(); ++x)
    {
      const double distance = std::hypot(x + 0.5 - centerX, y + 0.5 - centerY);
      stray += std::abs(distance - radius) > reach && image.Gray(x, y) < 250;
    }
  }
  return stray;
}

class SplattingLinesSphere : public testing::TestWithParam<int>
{
};

} // namespace

/// A sphere's contour is a closed ring, whatever its size in pixels and points. Where splats are summed up
/// for several pixels at once, it may be as much broader.
TEST_P(SplattingLinesSphere, HasAClosedContour)
{
  const int maximumDownsampling = GetParam();
  for (double spacing : { 0.08, 0.05, 0.02 })
  {
    for (bool parallel : { false, true })
    {
      SplattingLinesScene scene(InkTestPoints::Sphere(1.0, spacing));
      scene.Mapper->SetMaximumDownsampling(maximumDownsampling);
      vtkCamera* camera = scene.Renderer->GetActiveCamera();
      camera->SetParallelProjection(parallel);
      camera->SetParallelScale(1.25);
      camera->SetViewAngle(30.0);
      camera->SetPosition(0.0, 0.0, 1.25 / std::tan(vtkMath::RadiansFromDegrees(15.0)));
      scene.Renderer->ResetCameraClippingRange();
      const InkTestImage image(scene.Window);
      const double distance = camera->GetDistance();
      // The ring under which the eye sees the sphere.
      const double radius = (parallel ? 1.0 : distance / std::sqrt(distance * distance - 1.0)) / 1.25 * 100.0;
      const double slack = (spacing > 0.06 ? 12.0 : 4.0) + 2.0 * maximumDownsampling;
      const int gaps = CountGaps(image, 100.0, 100.0, radius - 1.0, 2);
      const int stray = CountStray(image, 100.0, 100.0, radius, slack);
      EXPECT_TRUE(gaps == 0 && stray == 0) << "a closed ring and nothing else; spacing " << spacing
                                           << (parallel ? " (parallel)" : " (perspective)") << ": " << gaps
                                           << " gaps, " << stray << " stray pixels";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
  MaximumDownsampling, SplattingLinesSphere, testing::Values(1, 2, 4), testing::PrintToStringParamName());

/// A plane that faces the viewer has no lines but is there: it hides what is behind.
TEST(SplattingLinesShapes, Plane)
{
  SplattingLinesScene scene(InkTestPoints::Plane(2.0, 0.05));
  scene.Mapper->SetTau(1.0);
  scene.Renderer->SetBackground(0.5, 0.5, 0.5);
  const InkTestImage image(scene.Window);
  EXPECT_EQ(image.CountDark(60, 60, 140, 140, 255), 0) << "a plane without lines or holes";
}

/// A torus seen from above has an outer and an inner contour; turned, its front hides part of the hole.
TEST(SplattingLinesShapes, Torus)
{
  SplattingLinesScene scene(InkTestPoints::Torus(1.0, 0.4, 0.03));
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.6);
  const InkTestImage image(scene.Window);
  const double pixels = 100.0 / 1.6;
  EXPECT_EQ(CountGaps(image, 100.0, 100.0, 1.4 * pixels - 1.0, 2), 0) << "a closed outer contour";
  EXPECT_EQ(CountGaps(image, 100.0, 100.0, 0.6 * pixels + 1.0, 2), 0) << "a closed inner contour";
  EXPECT_EQ(image.CountDark(100, 100 + int(0.8 * pixels), 101, 100 + int(1.2 * pixels)), 0)
    << "no lines on the torus' back";
}

/// Where a near object lies before a far one, its whole contour is drawn, and no halo outside of it.
TEST(SplattingLinesShapes, Occlusion)
{
  auto points = InkTestPoints::Join(
    InkTestPoints::Sphere(1.0, 0.03), InkTestPoints::Sphere(0.3, 0.03, { 0.0, 0.0, 1.5 }));
  SplattingLinesScene scene(points);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(1.25);
  const InkTestImage image(scene.Window);
  EXPECT_EQ(CountGaps(image, 100.0, 100.0, 0.3 * 80.0 - 1.0, 2), 0) << "a contour before the far sphere";
  const double between = 0.6 * 80.0;
  EXPECT_EQ(CountGaps(image, 100.0, 100.0, between, 8), 360) << "nothing between the contours";
}

/// A surface seen from behind is drawn too, unless its actor culls back faces.
TEST(SplattingLinesShapes, BackFaces)
{
  SplattingLinesScene scene(InkTestPoints::Plane(2.0, 0.05));
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  scene.Renderer->GetActiveCamera()->Azimuth(180.0);
  const InkTestImage seen(scene.Window);
  EXPECT_EQ(seen.CountDark(60, 60, 140, 140, 255), 0) << "a plane from behind";
  scene.Actor->GetProperty()->BackfaceCullingOn();
  const InkTestImage culled(scene.Window);
  EXPECT_EQ(culled.CountDark(), 200 * 200) << "nothing when back faces are culled";
  scene.Renderer->GetActiveCamera()->Azimuth(180.0);
  const InkTestImage front(scene.Window);
  EXPECT_EQ(front.CountDark(60, 60, 140, 140, 255), 0) << "the front when back faces are culled";
  scene.Actor->GetProperty()->BackfaceCullingOff();
  scene.Actor->GetProperty()->FrontfaceCullingOn();
  const int different = InkTestImage(scene.Window).CountDifferent(seen);
  EXPECT_LT(different, 200) << "front-face culling is not for ink, but " << different << " pixels differ";
}
