// SPDX-License-Identifier: BSD-3-Clause
// Splats as published: every pixel against equations 1 and 2 of Zhang et al. 2014 and E = tanh(phi (I1 - tau
// I2)), worked out on the CPU from the points alone: flat and curved, one behind the other, with parallel
// rays and in perspective.
#include "InkTestImage.h"
#include "SplattingLinesScene.h"
#include "TestSplats.h"

#include "vtkMath.h"

#include <gtest/gtest.h>

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <vector>

namespace
{

/// Points in the plane z = 0 whose normals wave, and whose radii differ.
std::vector<Splat> MakeSplats()
{
  std::vector<Splat> splats;
  for (int i = 0; i < 11; ++i)
  {
    for (int j = 0; j < 11; ++j)
    {
      const double x = 0.1 * i - 0.5;
      const double y = 0.1 * j - 0.5;
      const double nx = 0.25 * std::sin(12.0 * x);
      const double ny = 0.2 * std::cos(9.0 * y);
      splats.push_back(
        { { x, y, 0.0 }, { nx, ny, std::sqrt(1.0 - nx * nx - ny * ny) }, 0.09 + 0.01 * ((i + 2 * j) % 3) });
    }
  }
  return splats;
}

/// Equation 1 at the line of sight through (x, y), along z; 0 where there is no splat.
double Illumination(const std::vector<Splat>& splats, double x, double y, double lambda, double sigma)
{
  double weighted = 0.0;
  double weights = 0.0;
  for (const Splat& splat : splats)
  {
    const double dx = x - splat.Position[0];
    const double dy = y - splat.Position[1];
    const double dz = -(splat.Normal[0] * dx + splat.Normal[1] * dy) / splat.Normal[2];
    const double distance2 = dx * dx + dy * dy + dz * dz;
    const double r = lambda * splat.Radius;
    if (distance2 <= r * r)
    {
      // Equation 2.
      const double variance = r * r * sigma * sigma;
      const double w = std::exp(-distance2 / (2.0 * variance)) / (2.0 * std::acos(-1.0) * variance);
      weighted += w * splat.Normal[2]; // f_i: the light is at the viewer
      weights += w;
    }
  }
  return weights > 0.0 ? weighted / weights : 0.0;
}

/// Sections 3.1 to 3.3 for the line of sight in a direction from an eye: depth splats, then illumination
/// splats whose depth is that of the depth image within 1.5 radii, both measured along -z.
/// @return ink, or nothing where there is no disc
std::optional<double> TraceInk(
  const std::vector<Splat>& splats, const glm::dvec3& eye, const glm::dvec3& direction, const Parameters& p)
{
  std::vector<SplatHit> hits;
  double depth = HUGE_VAL;
  double side = 1.0;
  for (const Splat& splat : splats)
  {
    const SplatHit& hit = hits.emplace_back(splat, eye, direction);
    if (hit.Distance2 <= hit.Radius * hit.Radius && hit.Depth < depth)
    {
      depth = hit.Depth;
      side = hit.Light < 0.0 ? -1.0 : 1.0;
    }
  }
  if (depth == HUGE_VAL)
  {
    return {};
  }
  return InkOfSplats(
    hits, p, side, [&](std::size_t i) { return std::abs(hits[i].Depth - depth) <= 1.5 * hits[i].Radius; });
}

} // namespace

/// Every pixel of a plane, whose normals wave, with parallel rays.
TEST(SplattingLinesEquations, Plane)
{
  const std::vector<Splat> splats = MakeSplats();
  SplattingLinesScene scene(ToPolyData(splats));
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(0.0, 0.0, 3.0);
  camera->SetParallelScale(0.4); // inside the points, so that every pixel is covered
  scene.Renderer->ResetCameraClippingRange();
  scene.Mapper->AsPublishedOn();

  for (const Parameters& p : { Parameters{ 1.5, 1.0, 40.0, 0.4 }, Parameters{ 1.2, 1.01, 20.0, 0.3 },
         Parameters{ 1.8, 1.0, 200.0, 0.6 }, Parameters{ 0.8, 1.05, 40.0, 0.4 },
         Parameters{ 0.4, 1.05, 40.0, 0.4 }, Parameters{ 3.0, 1.0, 200.0, 0.4 } })
  {
    p.Give(scene.Mapper);
    const InkTestImage image(scene.Window);
    int wrong = 0;
    int worst = 0;
    int darkest = 255;
    for (int j = 0; j < image.GetHeight(); ++j)
    {
      for (int i = 0; i < image.GetWidth(); ++i)
      {
        const double x = ((i + 0.5) / image.GetWidth() - 0.5) * 0.8;
        const double y = ((j + 0.5) / image.GetHeight() - 0.5) * 0.8;
        const double difference = Illumination(splats, x, y, p.Lambda, p.Sigma) -
          p.Tau * Illumination(splats, x, y, p.Lambda, 1.6 * p.Sigma);
        const double ink = std::max(0.0, -std::tanh(p.Phi * difference));
        const int expected = static_cast<int>(std::lround(255.0 * (1.0 - ink)));
        const int error = std::abs(image.Gray(i, j) - expected);
        // A rim that passes through a pixel's center may go either way: a jump of the truncated Gaussian.
        wrong += error > 2;
        worst = std::max(worst, error);
        darkest = std::min(darkest, expected);
      }
    }
    const int pixels = image.GetWidth() * image.GetHeight();
    EXPECT_LT(darkest, 200) << "lines in the expected picture; the darkest pixel is " << darkest;
    EXPECT_LE(wrong, pixels / 10000) << "the equations' brightness within 2 of 255 at lambda " << p.Lambda
                                     << ", tau " << p.Tau << ", phi " << p.Phi << ", sigma " << p.Sigma
                                     << "; " << wrong << " of " << pixels << " pixels are not, the worst by "
                                     << worst;
  }

  scene.Mapper->AsPublishedOff();
  const InkTestImage refined(scene.Window);
  scene.Mapper->AsPublishedOn();
  EXPECT_GT(refined.CountDifferent(InkTestImage(scene.Window), 8), 100) << "AsPublished to make a difference";
}

/// Every pixel of curved surfaces of which one hides a part of the other, in perspective.
TEST(SplattingLinesEquations, Curved)
{
  std::vector<Splat> splats;
  AddSphere(splats, 1.0, 0.12, { 0.0, 0.0, 0.0 });
  AddSphere(splats, 0.4, 0.07, { 0.5, 0.3, 1.1 });
  SplattingLinesScene scene(ToPolyData(splats), 160, 160);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(0.0, 0.0, 3.5);
  camera->SetViewAngle(40.0);
  scene.Renderer->ResetCameraClippingRange();
  scene.Renderer->SetBackground(0.0, 0.0, 1.0);
  scene.Mapper->AsPublishedOn();
  const double tangent = std::tan(vtkMath::RadiansFromDegrees(20.0));
  for (const Parameters& p : { Parameters{ 0.6, 1.0, 40.0, 0.4 }, Parameters{ 1.0, 0.99, 40.0, 0.4 },
         Parameters{ 2.5, 0.99, 100.0, 0.4 }, Parameters{ 4.0, 1.0, 40.0, 0.3 } })
  {
    p.Give(scene.Mapper);
    const InkTestImage image(scene.Window);
    int wrong = 0;
    double ink = 0.0;
    for (int j = 0; j < 160; ++j)
    {
      for (int i = 0; i < 160; ++i)
      {
        const glm::dvec3 direction(
          ((i + 0.5) / 80.0 - 1.0) * tangent, ((j + 0.5) / 80.0 - 1.0) * tangent, -1.0);
        const std::optional<double> traced = TraceInk(splats, { 0.0, 0.0, 3.5 }, direction, p);
        const int expected = static_cast<int>(std::lround(255.0 * (1.0 - traced.value_or(1.0))));
        // The background is blue, and so without red.
        wrong += std::abs(image.Channel(i, j, 0) - expected) > 2;
        ink += traced.value_or(0.0);
      }
    }
    EXPECT_GT(ink, 1000.0) << "ink of more than 1000 pixels at lambda " << p.Lambda << "; " << ink;
    // Rims that pass through pixels' centers, and depths that differ by just the tolerance.
    EXPECT_LE(wrong, 4) << "curved surfaces within 2 of 255 at lambda " << p.Lambda << "; " << wrong
                        << " pixels are not";
  }
}
