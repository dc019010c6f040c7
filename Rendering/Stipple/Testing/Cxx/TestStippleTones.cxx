// SPDX-License-Identifier: BSD-3-Clause
// What is on the picture: the area of dots, the gray over distance, the sliders' ink, colors.
#include "InkTestImage.h"
#include "InkTestMessages.h"
#include "InkTestStipples.h"
#include "StippleScene.h"
#include "vtkInkStippleControls.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkLight.h"
#include "vtkMath.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace
{

/// The mean tone of a sphere within its outline, at a distance.
double SphereTone(StippleScene& scene, double distance)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, distance);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  scene.Renderer->ResetCameraClippingRange();
  const int height = scene.Window->GetSize()[1];
  const double pixels = height /
    (2.0 * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle())) *
      std::sqrt(distance * distance - 1.0));
  return InkTestImage(scene.Window).Ink() / (vtkMath::Pi() * pixels * pixels);
}

} // namespace

/// A dot's ink is its area, whatever its size and its position within pixels.
TEST(StippleTones, DotArea)
{
  auto plane = InkTestStipples::PlaneSurface(1.6, 5, 1);
  for (double size : { 0.4, 1.0, 1.5, 3.3, 8.0 })
  {
    StippleScene scene(plane);
    scene.AllOff();
    scene.Mapper->GrowWithZoomOff();
    scene.Mapper->SetPixelsPerStipple(1.0);
    scene.Mapper->SetStippleSize(size);
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    scene.Renderer->GetActiveCamera()->SetParallelScale(1.0);
    const double expected = 25.0 * vtkMath::Pi() * size * size / 4.0;
    const double found = InkTestImage(scene.Window).Ink();
    EXPECT_LT(std::abs(found / expected - 1.0), 0.04)
      << "ink of 25 dots of " << size << " pixels: " << expected << ", found " << found;
  }
}

/// The same gray over four octaves of distance, from voxels of several pixels to several voxels in a pixel.
TEST(StippleTones, SameGray)
{
  auto voxels = InkTestStipples::SphereVoxels(1.0, 0.04, 12);
  for (int way : { vtkInkStippleMapper::INTENSITY, vtkInkStippleMapper::PROBABILITY })
  {
    StippleScene scene(voxels, 500, 500);
    vtkNew<vtkLight> lamp;
    scene.Mapper->SetSmallElements(way);
    scene.Mapper->BoundaryOff();
    scene.Mapper->SilhouetteOff();
    scene.Mapper->InteriorOff();
    scene.Mapper->DistanceOff();
    scene.Mapper->SetPixelsPerStipple(15.0);
    scene.Renderer->GetActiveCamera()->SetViewAngle(10.0);
    // At the eye: the shade depends on what part of the sphere is seen otherwise.
    scene.Renderer->RemoveAllLights();
    scene.Renderer->AddLight(lamp);
    lamp->SetLightTypeToCameraLight();
    lamp->SetPosition(0.0, 0.0, 1.0);
    lamp->SetFocalPoint(0.0, 0.0, 0.0);
    lamp->PositionalOn();
    scene.Mapper->SetStippleSize(1.5);
    double least = 1e9;
    double most = 0.0;
    for (double distance : { 13.0, 26.0, 52.0, 104.0, 208.0 })
    {
      const double tone = SphereTone(scene, distance);
      least = std::min(least, tone);
      most = std::max(most, tone);
    }
    // By random values, there are but some hundred stipples in the smallest picture.
    const double tolerance = way == vtkInkStippleMapper::INTENSITY ? 1.10 : 1.25;
    EXPECT_TRUE(least > 0.02 && most / least < tolerance)
      << "the same gray at all distances, way " << way << ": " << least << " to " << most;
  }
}

/// Close up, where the lists run out, too: until a few elements fill the window.
TEST(StippleTones, SameGrayCloseUp)
{
  auto plane = InkTestStipples::PlaneSurface(2.0, 40, 16);
  StippleScene scene(plane, 300, 300);
  scene.AllOff();
  scene.Mapper->SetPixelsPerStipple(20.0);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  const double expected = vtkMath::Pi() / 20.0;
  for (double scale : { 1.0, 0.5, 0.25, 0.125, 0.0625, 0.025 })
  {
    scene.Renderer->GetActiveCamera()->SetParallelScale(scale * 0.98);
    const double found = InkTestImage(scene.Window).Ink() / (300.0 * 300.0);
    EXPECT_LT(std::abs(found / expected - 1.0), (scale < 0.1 ? 0.12 : 0.06))
      << "gray " << expected << " at scale " << scale << ", found " << found;
  }
}

/// More light, less ink; on dark paper the other way round. Opacity thins.
TEST(StippleTones, Polarity)
{
  auto voxels = InkTestStipples::SphereVoxels(1.0, 0.06, 12);
  StippleScene scene(voxels);
  scene.Mapper->BoundaryOff();
  scene.Mapper->SilhouetteOff();
  const InkTestImage dark(scene.Window);
  const auto middle = [](const InkTestImage& image)
  {
    double sum = 0.0;
    for (int y = 85; y < 115; ++y)
    {
      for (int x = 85; x < 115; ++x)
      {
        sum += image.Gray(x, y) / 255.0;
      }
    }
    return sum / 900.0;
  };
  EXPECT_GT(middle(dark), 0.93) << "light where the headlight falls, " << middle(dark);
  scene.Actor->GetProperty()->SetOpacity(0.5);
  const double half = InkTestImage(scene.Window).Ink() / dark.Ink();
  EXPECT_TRUE(half > 0.45 && half < 0.62) << "about half the ink with half the opacity: " << half;
  scene.Actor->GetProperty()->SetOpacity(1.0);
  scene.Mapper->SetInkColor(1.0, 1.0, 1.0);
  scene.Mapper->LightInkOn();
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  const InkTestImage light(scene.Window);
  EXPECT_TRUE(middle(light) > 0.2 && light.Gray(3, 3) == 0)
    << "white stipples where the headlight falls, " << middle(light);
}

/// The controls through the mapper: ink on the picture follows the sliders.
TEST(StippleTones, Controls)
{
  auto voxels = InkTestStipples::SphereVoxels(1.0, 0.06, 24);
  StippleScene scene(voxels);
  vtkNew<vtkInkStippleControls> controls;
  const auto ink = [&]
  {
    controls->Apply(scene.Mapper);
    scene.Mapper->SetSizeUnitToPixels();
    return InkTestImage(scene.Window).Ink();
  };
  const auto expect = [&](void (vtkInkStippleControls::*set)(double), double direction, const char* name)
  {
    controls->Reset();
    double last = 0.0;
    for (double slider : { 0.0, 0.25, 0.5, 0.75, 1.0 })
    {
      (controls.Get()->*set)(slider);
      const double now = ink();
      EXPECT_TRUE(slider == 0.0 || direction * (now - last) > 0.0)
        << name << " to " << slider << ": ink from " << last << " to " << now;
      last = now;
    }
  };
  expect(&vtkInkStippleControls::SetGradient, 1.0, "gradient");
  expect(&vtkInkStippleControls::SetSharpness, -1.0, "sharpness");
  expect(&vtkInkStippleControls::SetInterior, -1.0, "interior");

  controls->Reset();
  const double reset = ink();
  controls->SetGradient(7.0);
  EXPECT_EQ(controls->GetGradient(), 1.0) << "a clamped slider";
  controls->Reset();
  EXPECT_EQ(ink(), reset) << "the same ink after a reset";
  vtkNew<InkTestMessages> messages;
  messages->Observe(controls);
  EXPECT_TRUE(!controls->SetPreset("oil") && messages->Messages.size() == 1 &&
    messages->Messages[0].find("engineering") != std::string::npos)
    << "one message about an unknown preset";
  for (int i = 0; i < vtkInkStippleControls::GetNumberOfPresets(); ++i)
  {
    EXPECT_TRUE(controls->SetPreset(vtkInkStippleControls::GetPresetName(i))) << "a preset";
    double paper[3];
    controls->GetPaperColor(paper);
    scene.Renderer->SetBackground(paper);
    controls->Apply(scene.Mapper);
    scene.Mapper->SetSizeUnitToPixels();
    const InkTestImage image(scene.Window);
    const double marks = paper[0] == 0.0 ? 200.0 * 200.0 - image.Ink() : image.Ink();
    EXPECT_TRUE(marks > 300.0 && marks < 15000.0) << controls->GetPreset() << ": marks " << marks;
  }
}

/// A hundredth of a slider's way is a small step anywhere, at the ends above all, from any preset.
TEST(StippleTones, SlidersAreContinuous)
{
  auto voxels = InkTestStipples::SphereVoxels(1.0, 0.06, 16);
  StippleScene scene(voxels);
  scene.Renderer->SetBackground(0.5, 0.5, 0.5);
  vtkNew<vtkInkStippleControls> controls;
  const struct
  {
    const char* Name;
    void (vtkInkStippleControls::*Set)(double);
  } sliders[] = { { "gradient", &vtkInkStippleControls::SetGradient },
    { "sharpness", &vtkInkStippleControls::SetSharpness },
    { "orientation", &vtkInkStippleControls::SetOrientation },
    { "distance", &vtkInkStippleControls::SetDistance }, { "interior", &vtkInkStippleControls::SetInterior },
    { "color", &vtkInkStippleControls::SetColor } };
  for (int preset = 0; preset < vtkInkStippleControls::GetNumberOfPresets(); ++preset)
  {
    controls->SetPreset(vtkInkStippleControls::GetPresetName(preset));
    for (const auto& [name, set] : sliders)
    {
      controls->Reset();
      // Black ink and white.
      const auto draw = [&](double slider)
      {
        (controls.Get()->*set)(slider);
        controls->Apply(scene.Mapper);
        scene.Mapper->SetSizeUnitToPixels();
        const InkTestImage image(scene.Window);
        double ink = 0.0;
        for (int pixel = 0; pixel < 200 * 200; ++pixel)
        {
          ink += std::abs(image.Gray(pixel % 200, pixel / 200) - image.Gray(0, 0)) / 255.0;
        }
        return ink;
      };
      double most = 0.0;
      double step = 0.0;
      double last = 0.0;
      for (const double slider : { 0.0, 0.01, 0.5, 0.51, 0.99, 1.0 })
      {
        const double ink = draw(slider);
        most = std::max(most, ink);
        if (slider == 0.01 || slider == 0.51 || slider == 1.0)
        {
          step = std::max(step, std::abs(ink - last));
        }
        last = ink;
      }
      EXPECT_TRUE(most > 100.0 && step < 0.045 * most)
        << controls->GetPreset() << ", " << name << ": small steps of ink, found one of " << step << " of "
        << most;
    }
  }
}

/// Scalars color elements only when asked to.
TEST(StippleTones, Colors)
{
  auto plane = InkTestStipples::PlaneSurface(2.0, 10, 16);
  vtkNew<vtkFloatArray> scalars;
  scalars->SetName("Scalars");
  for (vtkIdType i = 0; i < plane->GetNumberOfCells(); ++i)
  {
    scalars->InsertNextValue(i % 10 < 5 ? 0.0f : 1.0f);
  }
  plane->GetCellData()->SetScalars(scalars);
  StippleScene scene(plane);
  scene.AllOff();
  scene.Mapper->SetStippleSize(4.0);
  const auto colored = [](const InkTestImage& image, int x0, int x1, int channel)
  {
    int count = 0;
    for (int y = 60; y < 140; ++y)
    {
      for (int x = x0; x < x1; ++x)
      {
        count += image.Channel(x, y, channel) > image.Channel(x, y, 2 - channel) + 100;
      }
    }
    return count;
  };
  const InkTestImage plain(scene.Window);
  EXPECT_TRUE(colored(plain, 0, 200, 0) == 0 && colored(plain, 0, 200, 2) == 0) << "black stipples";
  scene.Mapper->ScalarVisibilityOn();
  scene.Mapper->SetScalarRange(0.0, 1.0);
  const InkTestImage image(scene.Window);
  EXPECT_TRUE(colored(image, 60, 95, 0) > 200 && colored(image, 105, 140, 0) == 0) << "red on the left";
  EXPECT_TRUE(colored(image, 105, 140, 2) > 200 && colored(image, 60, 95, 2) == 0) << "blue on the right";
}
