// SPDX-License-Identifier: BSD-3-Clause
// The ends of what the mapper accepts: sliders, distances, single stipples and a million of them; that no
// parameter sends stipples again; and that what a generator makes is hidden by its own input.
#include "InkTestImage.h"
#include "InkTestMessages.h"
#include "InkTestStipples.h"
#include "StippleScene.h"
#include "vtkInkStippleControls.h"
#include "vtkInkStippleGenerator.h"

#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace
{

/// All that the shader gives is finite, opacities and colors within [0, 1].
void CheckMarks(StippleScene& scene, const std::string& what)
{
  vtkNew<InkTestMessages> messages;
  messages->Observe(scene.Mapper);
  scene.Window->Render();
  vtkNew<vtkFloatArray> marks;
  ASSERT_TRUE(scene.Mapper->EvaluateMarks(scene.Renderer, scene.Actor, marks)) << "marks with " << what;
  int wrong = 0;
  for (vtkIdType i = 0; i < marks->GetNumberOfTuples(); ++i)
  {
    const double* mark = marks->GetTuple(i);
    bool good = mark[0] >= 0.0 && mark[1] >= 0.0 && mark[1] <= 1.0 && mark[2] >= 0.0;
    for (int n = 0; n < 6; ++n)
    {
      good = good && std::isfinite(mark[n]) && (n < 3 || (mark[n] >= 0.0 && mark[n] <= 1.0));
    }
    wrong += !good;
  }
  EXPECT_EQ(wrong, 0) << wrong << " of " << marks->GetNumberOfTuples() << " marks out of range with " << what;
  EXPECT_TRUE(messages->Messages.empty()) << "no message with " << what;
}

/// The mean tone of a sphere within its outline, at a radius in pixels, over some offsets within pixels: a
/// window's brightness has 256 steps only.
double FindTone(StippleScene& scene, double radius)
{
  constexpr int offsets = 5;
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetParallelScale(0.5 * scene.Window->GetSize()[1] / radius);
  double ink = 0.0;
  for (int offset = 0; offset < offsets; ++offset)
  {
    const double x = 0.2 * offset / radius;
    const double y = 0.2 * (3 * offset % offsets) / radius;
    camera->SetPosition(x, y, 10.0);
    camera->SetFocalPoint(x, y, 0.0);
    ink += InkTestImage(scene.Window).Ink() / offsets;
  }
  return ink / (vtkMath::Pi() * radius * radius);
}

} // namespace

TEST(StippleExtremes, Sliders)
{
  StippleScene scene(InkTestStipples::SphereVoxels(1.0, 0.15, 8));
  vtkNew<vtkInkStippleControls> controls;
  for (int preset = 0; preset < vtkInkStippleControls::GetNumberOfPresets(); ++preset)
  {
    std::vector<double> inks;
    for (int ends = 0; ends < 64; ++ends)
    {
      controls->SetPreset(vtkInkStippleControls::GetPresetName(preset));
      controls->SetGradient(ends & 1);
      controls->SetSharpness(ends >> 1 & 1);
      controls->SetOrientation(ends >> 2 & 1);
      controls->SetDistance(ends >> 3 & 1);
      controls->SetInterior(ends >> 4 & 1);
      controls->SetColor(ends >> 5 & 1);
      controls->Apply(scene.Mapper);
      scene.Mapper->SetSizeUnitToPixels();
      const std::string name = std::string(controls->GetPreset()) + ", ends " + std::to_string(ends);
      CheckMarks(scene, name);
      double paper[3];
      controls->GetPaperColor(paper);
      scene.Renderer->SetBackground(paper);
      const InkTestImage picture(scene.Window);
      inks.push_back(std::abs(picture.Ink() - (1.0 - paper[0]) * picture.GetWidth() * picture.GetHeight()));
      EXPECT_GT(inks.back(), 0.6) << "something is drawn with " << name; // measured: 1.24 at least
    }
    // In pixels; measured: 1.2 to 4.2 where all that lessens ink is at its end, 9,479 to 10,796 where all
    // that adds to it is.
    EXPECT_LT(inks[54], 8.0) << "hardly any ink with " << controls->GetPreset();
    EXPECT_GT(inks[13], 5000.0) << "nearly all ink with " << controls->GetPreset();
  }
}

/// From inside the object to a hundredth of a pixel.
TEST(StippleExtremes, Distances)
{
  // The ink found when the pictures were checked by eye. What the eye is in or right before is all lit or
  // turned away.
  constexpr std::array distances{ 0.0, 0.5, 1.0, 1.001, 1.05, 2.0, 1e2, 1e3, 1e5, 1e7 };
  using Inks = std::array<double, distances.size()>;
  const struct
  {
    vtkSmartPointer<vtkPolyData> Stipples;
    std::array<Inks, 2> Ink; ///< in perspective and parallel
  } cases[] = {
    { InkTestStipples::SphereVoxels(1.0, 0.1, 8),
      { Inks{ 0, 0, 0, 0, 0, 758, 11.7, 0.141, 0, 0 },
        { 0, 0, 7661, 7663, 7173, 1989, 0.894, 0.016, 0, 0 } } },
    { InkTestStipples::SphereSurface(1.0, 500, 8),
      { Inks{ 0, 0, 0, 0, 38920, 8467, 22.5, 0.282, 0, 0 },
        { 0, 0, 16139, 16111, 14752, 4052, 1.835, 0.016, 0, 0 } } },
  };
  for (const auto& [data, inks] : cases)
  {
    StippleScene scene(data);
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    for (int parallel : { 0, 1 })
    {
      camera->SetParallelProjection(parallel);
      for (std::size_t i = 0; i < distances.size(); ++i)
      {
        const double distance = distances[i];
        const double expected = inks[parallel][i];
        camera->SetPosition(0.0, 0.0, distance);
        camera->SetFocalPoint(0.0, 0.0, distance - 1.0);
        camera->SetParallelScale(std::max(1e-3, distance));
        scene.Renderer->ResetCameraClippingRange();
        CheckMarks(scene, "distance " + std::to_string(distance));
        const double ink = InkTestImage(scene.Window).Ink();
        // A few pixels' brightness has few steps.
        EXPECT_LE(std::abs(ink - expected), 0.2 * expected + (expected > 0.0 ? 3.0 / 255.0 : 0.0))
          << (parallel ? "parallel" : "perspective") << " at distance " << distance << ": ink of " << expected
          << ", found " << ink;
      }
    }
  }
}

/// The gray of a sphere stays what it is until the sphere is a pixel, also under depth peeling, whose 8 bits
/// cannot add up as pale stipples as there are then.
TEST(StippleExtremes, TinySphere)
{
  const auto voxels = InkTestStipples::SphereVoxels(1.0, 0.04, 12);
  for (const bool preset : { false, true })
  {
    for (const bool peeled : { false, true })
    {
      StippleScene scene(voxels, 100, 100);
      scene.AllOff();
      // Few enough that stipples hardly ever lie on each other, which would make them paler together.
      scene.Mapper->SetPixelsPerStipple(120.0);
      scene.Mapper->SetStippleSize(1.5);
      if (preset)
      {
        vtkNew<vtkInkStippleControls> controls;
        controls->Apply(scene.Mapper);
        scene.Mapper->SetSizeUnitToPixels();
        scene.Mapper->HeadlightOn();
      }
      scene.Renderer->SetUseDepthPeeling(peeled);
      vtkCamera* camera = scene.Renderer->GetActiveCamera();
      camera->ParallelProjectionOn();
      camera->SetPosition(0.0, 0.0, 10.0);
      camera->SetFocalPoint(0.0, 0.0, 0.0);
      camera->SetClippingRange(8.0, 12.0);
      const double expected = FindTone(scene, 40.0);
      struct Size
      {
        double Radius;
        double Tolerance;
        double Peeled; // in the least spheres there are no more than five of the palest dots that 8 bits take
      };
      for (const auto& [radius, added, stepped] :
        { Size{ 20.0, 0.02, 0.02 }, Size{ 10.0, 0.02, 0.03 }, Size{ 5.0, 0.04, 0.06 },
          Size{ 2.0, 0.08, 0.13 }, Size{ 1.0, 0.11, 0.34 }, Size{ 0.5, 0.11, 0.34 } })
      {
        const double tone = FindTone(scene, radius);
        const double tolerance = peeled ? stepped : added;
        EXPECT_LT(std::abs(tone / expected - 1.0), tolerance)
          << "gray " << expected << " of a sphere of " << radius << " pixels' radius"
          << (peeled ? ", peeled" : "") << (preset ? ", anatomy" : "") << ", found " << tone;
      }
    }
  }
}

TEST(StippleExtremes, Many)
{
  auto stipples = InkTestStipples::SphereVoxels(1.0, 0.014, 8);
  EXPECT_GT(stipples->GetNumberOfPoints(), 1000000)
    << "a million stipples, " << stipples->GetNumberOfPoints();
  StippleScene scene(stipples);
  const double ink = InkTestImage(scene.Window).Ink();
  // As it was found when the picture was checked by eye.
  EXPECT_LT(std::abs(ink - 2203.0), 22.0) << "a picture of a million stipples, ink of 2203, found " << ink;
  EXPECT_LT(scene.Mapper->GetNumberOfProcessedStipples(), stipples->GetNumberOfPoints() / 12)
    << "few of them processed: " << scene.Mapper->GetNumberOfProcessedStipples();
}

/// Parameters are uniforms: none sends stipples again. What each does to the picture other tests say.
TEST(StippleExtremes, Uploads)
{
  StippleScene scene(InkTestStipples::SphereVoxels(1.0, 0.1, 8));
  scene.Window->Render();
  const vtkMTimeType time = scene.Mapper->GetUploadTime();
  vtkInkStippleMapper* m = scene.Mapper;
  using Set = void (vtkInkStippleMapper::*)(double);
  const Set numbers[] = { &vtkInkStippleMapper::SetBoundaryBase, &vtkInkStippleMapper::SetBoundaryGain,
    &vtkInkStippleMapper::SetBoundaryExponent, &vtkInkStippleMapper::SetSilhouetteBase,
    &vtkInkStippleMapper::SetSilhouetteGain, &vtkInkStippleMapper::SetSilhouetteExponent,
    &vtkInkStippleMapper::SetSlantExponent, &vtkInkStippleMapper::SetLightingExponent,
    &vtkInkStippleMapper::SetFacingAngle, &vtkInkStippleMapper::SetDistanceExponent,
    &vtkInkStippleMapper::SetDistanceSize, &vtkInkStippleMapper::SetInteriorExponent,
    &vtkInkStippleMapper::SetInteriorSize, &vtkInkStippleMapper::SetValueEffect,
    &vtkInkStippleMapper::SetPixelsPerStipple, &vtkInkStippleMapper::SetStippleSize,
    &vtkInkStippleMapper::SetMinimumCoverage, &vtkInkStippleMapper::SetFade,
    &vtkInkStippleMapper::SetWarmCool, &vtkInkStippleMapper::SetToneWeight,
    &vtkInkStippleMapper::SetDistanceWeight, &vtkInkStippleMapper::SetOccluderOffset };
  for (const Set set : numbers)
  {
    (m->*set)(0.7);
    scene.Window->Render();
  }
  using Switch = void (vtkInkStippleMapper::*)(bool);
  const Switch switches[] = { &vtkInkStippleMapper::SetBoundary, &vtkInkStippleMapper::SetSilhouette,
    &vtkInkStippleMapper::SetResolution, &vtkInkStippleMapper::SetLighting, &vtkInkStippleMapper::SetDistance,
    &vtkInkStippleMapper::SetInterior, &vtkInkStippleMapper::SetHeadlight, &vtkInkStippleMapper::SetLightInk,
    &vtkInkStippleMapper::SetGrowWithZoom, &vtkInkStippleMapper::SetFadeBySize };
  for (const Switch set : switches)
  {
    (m->*set)(false);
    scene.Window->Render();
    (m->*set)(true);
    scene.Window->Render();
  }
  m->SetResolutionExponent(-1.0);
  m->SetSmallElements(vtkInkStippleMapper::PROBABILITY);
  m->SetInkColor(0.5, 0.0, 0.0);
  m->SetWarmColor(1.0, 1.0, 0.0);
  scene.Window->Render();
  EXPECT_EQ(m->GetUploadTime(), time) << "no upload for any parameter";
}

/// Stipples that a generator made of a mesh are hidden by that mesh, unless told otherwise.
TEST(StippleExtremes, SurfaceFromInput)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(40);
  vtkNew<vtkInkStippleGenerator> generator;
  generator->SetInputConnection(sphere->GetOutputPort());
  generator->SetNumberOfSurfaceStipples(8000);
  generator->Update();
  vtkPolyData* stipples = generator->GetOutput();
  // Seen from inside, hidden by nothing: only a surface makes both sides of it count.
  StippleScene scene(stipples);
  scene.AllOff();
  scene.Mapper->SetInputConnection(generator->GetOutputPort());
  scene.Renderer->ResetCamera();
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  const double eye = camera->GetPosition()[2];
  const auto countBehind = [&](int front)
  {
    scene.Window->Render();
    vtkNew<vtkFloatArray> marks;
    scene.Mapper->EvaluateMarks(scene.Renderer, scene.Actor, marks);
    int shown[2] = { 0, 0 };
    for (vtkIdType i = 0; i < marks->GetNumberOfTuples(); ++i)
    {
      const double z = stipples->GetPoint(i)[2];
      shown[z < 1.0 / eye] += marks->GetComponent(i, 1) > 0.0 && std::abs(z - 1.0 / eye) > 0.2;
    }
    EXPECT_NEAR(shown[0], front, 0.1 * front) << "stipples on the front";
    return shown[1];
  };
  EXPECT_EQ(countBehind(2594), 0) << "none behind";
  // A hole in the surface lets the inside be seen, and only with the mesh is the inside drawn at all.
  sphere->SetStartPhi(60.0);
  generator->Update();
  camera->SetPosition(0.0, 0.0, eye);
  EXPECT_NEAR(countBehind(822), 4042, 400) << "the inside through a hole";
  scene.Mapper->SurfaceFromInputOff();
  EXPECT_EQ(countBehind(822), 0) << "no inside without the mesh";
}
