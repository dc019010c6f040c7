// SPDX-License-Identifier: BSD-3-Clause
// Pictures that were checked by eye: a volume and a surface with what most drawings use.
#include "InkTestBaseline.h"
#include "InkTestStipples.h"
#include "StippleScene.h"

#include "vtkLight.h"

#include <gtest/gtest.h>

namespace
{

/// The thresholded difference that another rasterizer's rounding makes.
constexpr double Tolerance = 30.0;

/// Not a preset: those may be redrawn.
void Compare(vtkPolyData* stipples, bool white, const char* name)
{
  StippleScene scene(stipples, 240, 240);
  scene.Mapper->SetPixelsPerStipple(5.0);
  scene.Mapper->SetStippleSize(1.8);
  if (white)
  {
    scene.Mapper->LightInkOn();
    scene.Mapper->SetInkColor(1.0, 1.0, 1.0);
    scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  }
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(-1.0, 1.0, 1.0);
  scene.Renderer->AddLight(light);
  scene.Renderer->GetActiveCamera()->Azimuth(30.0);
  scene.Renderer->GetActiveCamera()->Elevation(20.0);
  scene.Renderer->ResetCamera();
  EXPECT_TRUE(InkTestMatchesBaseline(InkTestImage(scene.Window), name, Tolerance)) << "the baseline " << name;
}

} // namespace

TEST(StippleBaselines, Volume)
{
  Compare(InkTestStipples::SphereVoxels(1.0, 0.04, 8), false, "StippleVolume");
}

TEST(StippleBaselines, SurfaceOnBlack)
{
  Compare(InkTestStipples::SphereSurface(1.0, 2000, 8), true, "StippleSurfaceOnBlack");
}
