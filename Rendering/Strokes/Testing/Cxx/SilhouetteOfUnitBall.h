// SPDX-License-Identifier: BSD-3-Clause
#ifndef SilhouetteOfUnitBall_h
#define SilhouetteOfUnitBall_h

#include "InkTestImage.h"

#include "vtkCamera.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

/// Expects of a picture of 200 x 200 pixels that a ball of radius 1 around the origin, of contours 3 pixels
/// wide, has a circle as its outline, whichever way the camera looks.
/// @param scene of a vtkInkSilhouetteMapper, with GetContours()
template <class Scene>
void ExpectOutlineOfUnitBall(Scene& scene, bool parallel)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetParallelProjection(parallel);
  camera->SetPosition(0.0, 0.0, 5.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewAngle(30.0);
  camera->SetParallelScale(1.3);
  scene.Renderer->ResetCameraClippingRange();
  const double radius =
    100.0 * (parallel ? 1.0 / 1.3 : 1.0 / std::sqrt(24.0) / std::tan(15.0 * std::numbers::pi / 180.0));
  for (const double azimuth : { 0.0, 17.0, 90.0 })
  {
    camera->Azimuth(azimuth);
    const InkTestImage image(scene.Window);
    EXPECT_NEAR(image.Ink() / (2.0 * std::numbers::pi * radius * 3.0), 1.0, 0.02)
      << azimuth << ' ' << parallel;
    for (int i = 0; i < 100; ++i)
    {
      const double angle = i * 2.0 * std::numbers::pi / 100;
      const auto darkAt = [&](double r)
      {
        return image.IsDark(
          static_cast<int>(100.0 + r * std::cos(angle)), static_cast<int>(100.0 + r * std::sin(angle)));
      };
      EXPECT_TRUE(darkAt(radius) && !darkAt(radius - 3.0) && !darkAt(radius + 3.0)) << i;
    }
    ASSERT_EQ(scene.GetContours()->GetNumberOfLines(), 1);
  }
}

#endif
