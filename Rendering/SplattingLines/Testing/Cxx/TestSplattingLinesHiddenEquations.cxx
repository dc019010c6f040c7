// SPDX-License-Identifier: BSD-3-Clause
// Hidden layers as published (Zhang et al. 2014, section 5.2): every pixel, worked out on the CPU. The paper
// tests a splat of a layer once, where its center is, and then draws all of it.
#include "InkTestImage.h"
#include "SplattingLinesScene.h"
#include "TestSplats.h"

#include "vtkMath.h"

#include <gtest/gtest.h>

#include <glm/vec3.hpp>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <vector>

namespace
{

constexpr int Size = 100;
const glm::dvec3 Eye(0.0, 0.0, 3.5);
const double Tangent = std::tan(vtkMath::RadiansFromDegrees(20.0));

glm::dvec3 DirectionAt(double x, double y)
{
  return { (2.0 * x / Size - 1.0) * Tangent, (2.0 * y / Size - 1.0) * Tangent, -1.0 };
}

std::size_t IndexOf(int i, int j)
{
  return static_cast<std::size_t>(j) * Size + static_cast<std::size_t>(i);
}

/// Of each pixel the depth of the nearest disc that faces the eye and lies behind a layer by more than the
/// depth test's 1.5 radii; infinite where there is none.
std::vector<double> FindDepths(const std::vector<Splat>& splats, const std::vector<double>& before)
{
  std::vector<double> depths(Size * Size, HUGE_VAL);
  for (int j = 0; j < Size; ++j)
  {
    for (int i = 0; i < Size; ++i)
    {
      for (const Splat& splat : splats)
      {
        const SplatHit hit(splat, Eye, DirectionAt(i + 0.5, j + 0.5));
        double& depth = depths[IndexOf(i, j)];
        if (hit.Light > 0.0 && hit.Distance2 <= hit.Radius * hit.Radius && hit.Depth < depth &&
          hit.Depth > before[IndexOf(i, j)] + 1.5 * hit.Radius)
        {
          depth = hit.Depth;
        }
      }
    }
  }
  return depths;
}

/// Of each splat, whether its center is on a layer. What is outside the picture cannot be told.
std::vector<char> FindShown(const std::vector<Splat>& splats, const std::vector<double>& depths)
{
  std::vector<char> shown;
  for (const Splat& splat : splats)
  {
    const double depth = Eye.z - splat.Position[2];
    const int i = static_cast<int>(std::floor((splat.Position[0] / (depth * Tangent) + 1.0) * Size / 2.0));
    const int j = static_cast<int>(std::floor((splat.Position[1] / (depth * Tangent) + 1.0) * Size / 2.0));
    const bool inside = i >= 0 && j >= 0 && i < Size && j < Size;
    shown.push_back(!inside || std::abs(depths[IndexOf(i, j)] - depth) <= 1.5 * splat.Radius);
  }
  return shown;
}

} // namespace

TEST(SplattingLinesHiddenEquations, OfTwoSpheres)
{
  // The inner one is not in the middle: its contour crosses the outer one's lines of sight obliquely.
  std::vector<Splat> splats;
  AddSphere(splats, 1.0, 0.12, { 0.0, 0.0, 0.0 });
  AddSphere(splats, 0.45, 0.07, { 0.25, 0.15, 0.1 });
  SplattingLinesScene scene(ToPolyData(splats), Size, Size);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(Eye.x, Eye.y, Eye.z);
  camera->SetViewAngle(40.0);
  scene.Renderer->ResetCameraClippingRange();
  scene.Mapper->AsPublishedOn();
  scene.Mapper->HiddenLayersOn();
  scene.Mapper->SetNumberOfLayers(2);
  // The second layer's ink alone.
  scene.Mapper->SetLayerStrength(0, 0.0);
  scene.Mapper->SetLayerStrength(1, 1.0);
  scene.Mapper->SetLayerColor(1, 0.0, 0.0, 0.0);

  const std::vector<double> nearest = FindDepths(splats, std::vector<double>(Size * Size, -HUGE_VAL));
  const std::vector<double> depths = FindDepths(splats, nearest);
  const std::vector<char> shown = FindShown(splats, depths);
  for (const Parameters& p : { Parameters{ 1.0, 0.99, 40.0, 0.4 }, Parameters{ 2.5, 0.99, 100.0, 0.4 } })
  {
    p.Give(scene.Mapper);
    const InkTestImage image(scene.Window);
    int wrong = 0;
    int byPixel = 0;
    double ink = 0.0;
    for (int j = 0; j < Size; ++j)
    {
      for (int i = 0; i < Size; ++i)
      {
        std::vector<SplatHit> hits;
        for (const Splat& splat : splats)
        {
          hits.emplace_back(splat, Eye, DirectionAt(i + 0.5, j + 0.5));
        }
        // Also where no disc of the layer is: splats reach over its outline.
        const double expected = InkOfSplats(hits, p, 1.0, [&](std::size_t k) { return shown[k] != 0; });
        const double depth = depths[IndexOf(i, j)];
        const double tested = InkOfSplats(hits, p, 1.0,
          [&](std::size_t k) { return std::abs(hits[k].Depth - depth) <= 1.5 * hits[k].Radius; });
        wrong +=
          std::abs(image.Channel(i, j, 0) - static_cast<int>(std::lround(255.0 * (1.0 - expected)))) > 2;
        byPixel += std::abs(expected - tested) > 2.0 / 255.0;
        ink += expected;
      }
    }
    EXPECT_GT(ink, 50.0) << "lambda " << p.Lambda;
    EXPECT_GT(byPixel, 40) << "splats tested in each pixel make another picture at lambda " << p.Lambda;
    EXPECT_LE(wrong, 2) << "the hidden layer within 2 of 255 at lambda " << p.Lambda;
  }
}
