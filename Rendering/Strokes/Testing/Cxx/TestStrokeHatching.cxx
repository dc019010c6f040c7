// SPDX-License-Identifier: BSD-3-Clause
// Hatching: the gray that is wanted at any zoom, light, crossing lines, what is not drawn, nothing that pops.
#include "HatchedSurfaces.h"
#include "InkTestImage.h"
#include "InkTestMessages.h"
#include "Tone/Hatching/StrokeWidth.h"

#include "vtkLight.h"
#include "vtkPlaneSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

/// The share of a rectangle of pixels that is covered, from its middle: its half width and half height.
double Tone(const InkTestImage& image, int halfWidth, int halfHeight)
{
  const int x0 = image.GetWidth() / 2;
  const int y0 = image.GetHeight() / 2;
  double ink = 0.0;
  for (int y = y0 - halfHeight; y < y0 + halfHeight; ++y)
  {
    for (int x = x0 - halfWidth; x < x0 + halfWidth; ++x)
    {
      ink += 1.0 - image.Gray(x, y) / 255.0;
    }
  }
  return ink / (4.0 * halfWidth * halfHeight);
}

vtkSmartPointer<vtkLight> AddHeadlight(HatchingScene& scene, double intensity)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToHeadlight();
  light->SetIntensity(intensity);
  scene.Renderer->AddLight(light);
  return light;
}

} // namespace

/// The gray of a plane that faces the eye, from lines of which many lie in a pixel to some that are pixels
/// apart.
TEST(StrokeHatching, GrayOfPlane)
{
  HatchedSurfaces surface;
  surface.AddPlane(8);
  HatchingScene scene(surface.Make());
  double worst = 0.0;
  // Of all of the plane, or of a window that holds a whole number of the most widely spaced lines.
  for (const double height : { 8.0, 3.5, 2.0, 1.0, 0.5, 0.125 })
  {
    scene.SetView(height, true);
    const double area = std::pow(300.0 * std::min(2.0 / height, 1.0), 2);
    for (const double tone : { 0.1, 0.2, 0.4, 0.6, 0.8 })
    {
      scene.Mapper->SetDarkestTone(tone);
      const double found = InkTestImage(scene.Window).Ink() / area;
      worst = std::max(worst, std::abs(found / tone - 1.0));
      EXPECT_NEAR(found / tone, 1.0, 0.05) << "tone " << tone << " of " << height << " in sight: " << found;
    }
  }
  RecordProperty("worst", std::to_string(worst));
}

/// The gray of a slanted surface: a cylinder's side out to where it is turned away by 64 degrees, with lines
/// around it, that come no closer there, and along it, that do; from near, too.
TEST(StrokeHatching, GrayOfCylinder)
{
  double worst = 0.0;
  for (const bool around : { true, false })
  {
    HatchedSurfaces surface;
    surface.AddCylinder(8, around);
    HatchingScene scene(surface.Make());
    for (const bool parallel : { true, false })
    {
      for (const double height : { 5.0, 2.4, 1.2 })
      {
        scene.SetView(height, parallel);
        const double radius = 300.0 / height;
        const int half = std::min(static_cast<int>((parallel ? 0.9 : 0.8) * radius), 150);
        for (const double tone : { 0.1, 0.4, 0.8 })
        {
          scene.Mapper->SetDarkestTone(tone);
          // The mean over several turns, as it is chance how many lines there are between the bounds.
          double found = 0.0;
          for (int turn = 0; turn < 3; ++turn)
          {
            scene.Actor->SetOrientation(0.0, 2.5 * turn, 0.0);
            found += Tone(InkTestImage(scene.Window), half, std::min(half, 120)) / 3.0;
          }
          worst = std::max(worst, std::abs(found / tone - 1.0));
          EXPECT_NEAR(found / tone, 1.0, 0.05)
            << "tone " << tone << ", lines " << (around ? "around" : "along") << ", height " << height
            << (parallel ? ", parallel" : ", perspective") << ": " << found;
        }
      }
    }
  }
  RecordProperty("worst", std::to_string(worst));
}

/// Two families that cross make the same tone as one.
TEST(StrokeHatching, GrayOfCrosshatching)
{
  HatchedSurfaces surface;
  surface.AddPlane(8, 0);
  surface.AddPlane(8, 1);
  HatchingScene scene(surface.Make());
  scene.SetView(1.9, true);
  for (const double crosshatching : { 0.0, 0.3, 0.6, 1.0 })
  {
    scene.Mapper->SetCrosshatching(crosshatching);
    for (const double tone : { 0.1, 0.3, 0.5, 0.8 })
    {
      scene.Mapper->SetDarkestTone(tone);
      const double found = Tone(InkTestImage(scene.Window), 140, 140);
      EXPECT_NEAR(found / tone, 1.0, 0.05)
        << "tone " << tone << ", crosshatching " << crosshatching << ": " << found;
    }
  }
}

/// Light as it falls, of the renderer's lights.
TEST(StrokeHatching, Light)
{
  HatchedSurfaces surface;
  surface.AddPlane(8);
  HatchingScene scene(surface.Make());
  scene.SetView(1.9, true);
  scene.Mapper->SetDarkestTone(1.0);
  vtkSmartPointer<vtkLight> light = AddHeadlight(scene, 0.7);
  EXPECT_NEAR(Tone(InkTestImage(scene.Window), 140, 140), 0.3, 0.015);
  light->SetIntensity(1.0);
  EXPECT_EQ(InkTestImage(scene.Window).Ink(), 0.0) << "white in full light";
  light->SetLightTypeToSceneLight();
  light->SetPosition(std::sqrt(3.0), 0.0, 1.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  EXPECT_NEAR(Tone(InkTestImage(scene.Window), 140, 140), 0.5, 0.025) << "cos 60 degrees";
  scene.Mapper->SetDiffuseTruncation(0.55);
  EXPECT_EQ(InkTestImage(scene.Window).Ink(), 0.0) << "a tone that is truncated";
}

/// A lamp beside the plane, from which light falls at another angle everywhere.
TEST(StrokeHatching, Lamp)
{
  HatchedSurfaces surface;
  surface.AddPlane(8);
  HatchingScene scene(surface.Make());
  scene.SetView(1.9, true);
  scene.Mapper->SetDarkestTone(1.0);
  const vtkSmartPointer<vtkLight> lamp = AddHeadlight(scene, 1.0);
  lamp->SetLightTypeToSceneLight();
  lamp->PositionalOn();
  lamp->SetConeAngle(180.0);
  lamp->SetPosition(2.0, 0.0, 1.0);
  lamp->SetFocalPoint(0.0, 0.0, 0.0);
  double dark = 0.0;
  for (int y = -140; y < 140; ++y)
  {
    for (int x = -140; x < 140; ++x)
    {
      const double unit = 1.9 / 300.0;
      dark += 1.0 - 1.0 / std::hypot((x + 0.5) * unit - 2.0, (y + 0.5) * unit, 1.0);
    }
  }
  EXPECT_NEAR(Tone(InkTestImage(scene.Window), 140, 140), dark / (280.0 * 280.0), 0.025);
}

/// Each slider moves the ink one way, or leaves it as it is.
TEST(StrokeHatching, Sliders)
{
  HatchedSurfaces surface;
  surface.AddCylinder(8, true);
  HatchingScene scene(surface.Make());
  scene.SetView(2.4, true);
  AddHeadlight(scene, 0.9);
  scene.Mapper->SetDarkestTone(0.9);
  scene.Mapper->SetSilhouetteWeight(0.3);
  const auto expect = [&](const char* name, int direction, double least, double most, double usual, auto set)
  {
    double before = 0.0;
    for (int i = 0; i <= 5; ++i)
    {
      (scene.Mapper.Get()->*set)(least + 0.2 * i * (most - least));
      const double ink = InkTestImage(scene.Window).Ink();
      EXPECT_TRUE(
        i == 0 || (direction == 0 ? std::abs(ink / before - 1.0) < 0.05 : direction * (ink - before) > 0.0))
        << name << " at step " << i << ": ink from " << before << " to " << ink;
      before = ink;
    }
    (scene.Mapper.Get()->*set)(usual);
  };
  using Mapper = vtkInkStrokeMapper;
  expect("tone", 1, 0.0, 1.0, 0.5, &Mapper::SetTone);
  expect("darkest tone", 1, 0.1, 1.0, 0.9, &Mapper::SetDarkestTone);
  expect("diffuse truncation", -1, 0.0, 0.9, 0.0, &Mapper::SetDiffuseTruncation);
  expect("silhouette truncation", -1, 0.0, 0.9, 0.5, &Mapper::SetSilhouetteTruncation);
  expect("spacing", 0, 3.0, 16.0, 6.0, &Mapper::SetHatchSpacing);
  expect("least width", 0, 0.0, 3.0, 0.8, &Mapper::SetLineWidth);
  expect("taper", 0, 0.0, 0.5, 0.0, &Mapper::SetTaper);
}

/// What faces away by more than the cosine is not drawn; what does from an open surface can be.
TEST(StrokeHatching, Culling)
{
  HatchedSurfaces surface;
  surface.AddPlane(6);
  HatchingScene scene(surface.Make());
  scene.SetView(2.4, true);
  scene.Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, -5.0);
  scene.Renderer->ResetCameraClippingRange();
  EXPECT_EQ(InkTestImage(scene.Window).Ink(), 0.0);
  scene.Mapper->SetCullingCosine(1.0);
  EXPECT_GT(InkTestImage(scene.Window).Ink(), 1000.0);
  AddHeadlight(scene, 1.0);
  EXPECT_EQ(InkTestImage(scene.Window).Ink(), 0.0) << "and is lit on that side";
}

/// Around the default of .2: what is just behind its silhouette is drawn, what faces away by more is not.
/// With 1, what is seen from behind is drawn, and not what is just behind its silhouette.
TEST(StrokeHatching, CullingCosine)
{
  HatchedSurfaces surface;
  surface.AddPlane(6);
  HatchingScene scene(surface.Make());
  scene.SetView(2.4, true);
  ASSERT_EQ(scene.Mapper->GetCullingCosine(), 0.2);
  const auto inkAt = [&](double cosine)
  {
    scene.Renderer->GetActiveCamera()->SetPosition(5.0 * std::sqrt(1.0 - cosine * cosine), 0.0, 5.0 * cosine);
    scene.Renderer->ResetCameraClippingRange();
    return InkTestImage(scene.Window).Ink();
  };
  EXPECT_GT(inkAt(0.19), 100.0);
  EXPECT_GT(inkAt(-0.19), 100.0);
  EXPECT_EQ(inkAt(-0.21), 0.0);
  scene.Mapper->SetCullingCosine(0.1);
  EXPECT_GT(inkAt(-0.09), 50.0);
  EXPECT_EQ(inkAt(-0.11), 0.0);
  scene.Mapper->SetCullingCosine(1.0);
  EXPECT_EQ(inkAt(-0.19), 0.0);
  EXPECT_GT(inkAt(-0.21), 100.0);
}

/// A surface hides hatching behind it and none on it, slanted or not.
TEST(StrokeHatching, Surface)
{
  HatchedSurfaces surface;
  surface.AddPlane(8);
  HatchingScene scene(surface.Make());
  scene.SetView(1.9, true);
  scene.Mapper->SetDarkestTone(0.5);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-1.0, -1.0, 0.0);
  plane->SetPoint1(1.0, -1.0, 0.0);
  plane->SetPoint2(-1.0, 1.0, 0.0);
  scene.Mapper->SetSurfaceConnection(plane->GetOutputPort());
  for (const double slant : { 0.0, 45.0, 70.0 })
  {
    scene.Renderer->GetActiveCamera()->SetPosition(5.0 * std::sin(slant * std::numbers::pi / 180.0), 0.0,
      5.0 * std::cos(slant * std::numbers::pi / 180.0));
    scene.Renderer->ResetCameraClippingRange();
    const int half = static_cast<int>(130.0 * std::cos(slant * std::numbers::pi / 180.0));
    scene.Mapper->SetSurfaceConnection(nullptr);
    const double without = Tone(InkTestImage(scene.Window), half, 120);
    scene.Mapper->SetSurfaceConnection(plane->GetOutputPort());
    EXPECT_NEAR(Tone(InkTestImage(scene.Window), half, 120) / without, 1.0, 0.01) << "slant " << slant;
  }
  scene.SetView(1.9, true);
  scene.Renderer->GetActiveCamera()->SetClippingRange(1.0, 10.0);
  plane->SetOrigin(-1.0, -1.0, 0.2);
  plane->SetPoint1(0.0, -1.0, 0.2);
  plane->SetPoint2(-1.0, 1.0, 0.2);
  const InkTestImage half(scene.Window);
  EXPECT_EQ(half.CountDark(0, 0, 148, 300, 250), 0) << "hidden";
  EXPECT_GT(half.CountDark(152, 0, 300, 300), 10000);
}

/// Widths as they are told draw the same strokes without hatching.
TEST(StrokeHatching, EvaluateWidths)
{
  HatchedSurfaces surface;
  surface.AddCylinder(5, true);
  const vtkSmartPointer<vtkPolyData> strokes = surface.Make();
  HatchingScene scene(strokes);
  vtkNew<vtkFloatArray> widths;
  EXPECT_FALSE(
    vtkSmartPointer<vtkInkStrokeMapper>::New()->EvaluateWidths(scene.Renderer, scene.Actor, widths))
    << "no input";
  scene.SetView(2.4, true);
  scene.Renderer->AddLight(vtkSmartPointer<vtkLight>::Take(vtkLight::New()));
  scene.Mapper->SetDarkestTone(0.9);
  const InkTestImage hatched(scene.Window);
  ASSERT_TRUE(scene.Mapper->EvaluateWidths(scene.Renderer, scene.Actor, widths));
  ASSERT_EQ(widths->GetNumberOfTuples(), strokes->GetNumberOfPoints());
  EXPECT_GT(widths->GetRange()[1], 1.0);
  EXPECT_EQ(widths->GetRange()[0], 0.0) << "of strokes that are left out";
  widths->SetName("Width");
  strokes->GetPointData()->AddArray(widths);
  scene.Mapper->HatchingOff();
  scene.Mapper->SetLineWidth(1.0);
  const InkTestImage drawn(scene.Window);
  EXPECT_GT(hatched.Ink(), 1000.0);
  for (int y = 0; y < 300; ++y)
  {
    for (int x = 0; x < 300; ++x)
    {
      ASSERT_NEAR(hatched.Gray(x, y), drawn.Gray(x, y), 1.0) << x << ", " << y;
    }
  }
}

/// Widths by ratios of positions, as those of the reference, at any zoom; without a step.
TEST(StrokeHatching, SpacingRatios)
{
  HatchedSurfaces surface;
  surface.AddPlane(6);
  const vtkSmartPointer<vtkPolyData> strokes = surface.Make();
  vtkNew<vtkFloatArray> ratios;
  ratios->SetName("SpacingRatio");
  ratios->SetNumberOfComponents(8);
  for (vtkIdType i = 0; i < strokes->GetNumberOfPoints(); ++i)
  {
    for (int k = 0; k < 8; ++k)
    {
      ratios->InsertNextValue(static_cast<float>(0.5 + ((i + 3 * k) % 8) / 7.0));
    }
  }
  HatchingScene plain(strokes);
  vtkNew<vtkPolyData> uneven;
  uneven->ShallowCopy(strokes);
  uneven->GetPointData()->AddArray(ratios);
  HatchingScene scene(uneven);
  const auto widths = [](HatchingScene& of)
  {
    vtkNew<vtkFloatArray> found;
    of.Window->Render();
    EXPECT_TRUE(of.Mapper->EvaluateWidths(of.Renderer, of.Actor, found));
    return vtkSmartPointer<vtkFloatArray>(found);
  };
  for (double height = 8.0; height > 0.2; height *= 0.93)
  {
    plain.SetView(height, true);
    scene.SetView(height, true);
    const vtkSmartPointer<vtkFloatArray> even = widths(plain);
    const vtkSmartPointer<vtkFloatArray> found = widths(scene);
    const double fraction = 300.0 / height * (2.0 / 64.0) / scene.Mapper->GetHatchSpacing();
    for (vtkIdType i = 0; i < strokes->GetNumberOfPoints(); i += 37)
    {
      ink::hatching::SpacingRatios own;
      ratios->GetTypedTuple(i, own.data());
      EXPECT_NEAR(found->GetValue(i),
        even->GetValue(i) * ink::hatching::spacingRatio(own, static_cast<float>(fraction)),
        2e-3 * even->GetValue(i))
        << "point " << i << ", fraction " << fraction;
    }
  }
  ratios->SetNumberOfComponents(4);
  vtkNew<InkTestMessages> messages;
  messages->Observe(scene.Mapper);
  ratios->Modified();
  uneven->Modified();
  EXPECT_EQ(InkTestImage(scene.Window).Ink(), 0.0);
  ASSERT_EQ(messages->Messages.size(), 1u);
  EXPECT_NE(messages->Messages[0].find("\"SpacingRatio\""), std::string::npos) << messages->Messages[0];
}

/// Nothing pops: pictures of nearby zooms, densities and tones are alike everywhere.
TEST(StrokeHatching, NothingPops)
{
  HatchedSurfaces surface;
  surface.AddPlane(7, 0);
  surface.AddPlane(7, 1);
  HatchingScene scene(surface.Make(), 200);
  scene.Mapper->SetCrosshatching(0.6);
  const auto mostChange = [&](const InkTestImage& one, const InkTestImage& other)
  {
    int most = 0;
    for (int y = 0; y < 200; ++y)
    {
      for (int x = 0; x < 200; ++x)
      {
        most = std::max(most, std::abs(one.Gray(x, y) - other.Gray(x, y)));
      }
    }
    return most;
  };
  for (double height = 4.0; height > 0.2; height *= 0.7)
  {
    scene.SetView(height, true);
    const InkTestImage before(scene.Window);
    // A thousandth: a tenth of a pixel at the picture's rim, both ways.
    scene.SetView(height * 0.999, true);
    EXPECT_LT(mostChange(before, InkTestImage(scene.Window)), 64) << "height " << height;
  }
  scene.SetView(1.9, true);
  for (double step = 0.0; step < 1.0; step += 0.1)
  {
    scene.Mapper->SetHatchSpacing(3.0 + 20.0 * step);
    const InkTestImage before(scene.Window);
    scene.Mapper->SetHatchSpacing((3.0 + 20.0 * step) * 1.002);
    EXPECT_LT(mostChange(before, InkTestImage(scene.Window)), 32) << "spacing at " << step;
    scene.Mapper->SetHatchSpacing(6.0);
    scene.Mapper->SetDarkestTone(0.05 + 0.8 * step);
    const InkTestImage paler(scene.Window);
    scene.Mapper->SetDarkestTone(0.052 + 0.8 * step);
    EXPECT_LT(mostChange(paler, InkTestImage(scene.Window)), 32) << "tone at " << step;
  }
}

/// Lines that are not hatching's are refused with what they lack.
TEST(StrokeHatching, MissingArrays)
{
  for (const char* name : { "Priority", "Spacing" })
  {
    HatchedSurfaces surface;
    surface.AddPlane(3);
    vtkSmartPointer<vtkPolyData> data = surface.Make();
    data->GetCellData()->RemoveArray(name);
    HatchingScene scene(data);
    vtkNew<InkTestMessages> messages;
    messages->Observe(scene.Mapper);
    EXPECT_EQ(InkTestImage(scene.Window).Ink(), 0.0);
    ASSERT_EQ(messages->Messages.size(), 1u);
    EXPECT_NE(messages->Messages[0].find('"' + std::string(name) + "\"."), std::string::npos)
      << messages->Messages[0];
    scene.Mapper->HatchingOff();
    EXPECT_GT(InkTestImage(scene.Window).Ink(), 0.0) << "as strokes they are drawn";
  }
}
