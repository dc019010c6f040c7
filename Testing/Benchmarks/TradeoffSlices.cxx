// SPDX-License-Identifier: BSD-3-Clause
// Iso-surfaces of scans in thick slices: by values or by distances from contours between them, smoothed or
// not.

#include "SampledVolume.h"
#include "Tradeoff.h"

#include "IsoSurface/ResampledSamples.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace
{

using namespace ink::testing;

constexpr double Radius = 40.0;
constexpr double SliceDistance = 6.0;

/// A ball, blurred by .7 samples within the slices, and across them by so many slices.
Volume<float> ScanBall(double slices)
{
  const glm::ivec3 size(96, 96, 18);
  const glm::dvec3 spacing(1.0, 1.0, SliceDistance);
  return Volume<float>::from(ink::GridGeometry(size, -0.5 * spacing * glm::dvec3(size - 1), spacing),
    [&](const glm::dvec3& p)
    {
      // By the direction of the surface: exact for a plane.
      const glm::dvec3 normal = p / std::max(glm::length(p), 1.0);
      const double blur = std::hypot(0.7, std::max(slices * SliceDistance, 0.7) * normal.z);
      return 0.5 * std::erfc((glm::length(p) - Radius) / (blur * std::sqrt(2.0)));
    });
}

Samples<float> SampleBall(const Volume<float>& volume, double isoValue, double smoothing, bool shapeBased)
{
  Samples<float> samples;
  const auto resampling = ink::makeIsoSurfaceResampling(
    volume.geometry, smoothing, 1, ink::SmoothingTarget::Normals, false, shapeBased);
  std::vector<std::size_t> counts;
  ink::sampleResampledIsoSurfaces(
    volume.field(), std::span(&isoValue, 1), {}, {}, resampling, 0, nullptr,
    [&](std::size_t count) { return samples.grow(count); }, counts);
  return samples;
}

/// Root mean square angle between normals and those of a ball, degrees.
double AngleOf(const Samples<float>& samples)
{
  double sum = 0.0;
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    const double cosine = glm::dot(samples.normal(n), glm::normalize(samples.point(n)));
    sum += std::pow(std::acos(std::clamp(cosine, -1.0, 1.0)), 2);
  }
  return std::sqrt(sum / static_cast<double>(samples.size())) * 180.0 / std::acos(-1.0);
}

} // namespace

int main()
{
  Tradeoff knob("ShapeBasedInterpolation (vtkInkIsoSurfaceSampler)",
    "Take contours where slices are sharp, above all for iso-values near what is outside, as that of skin "
    "in MR; where slices blur into each other, values are better (ink::suggestShapeBasedInterpolation).",
    "angle between normals and the true ones, degrees (root mean square): slices that are as sharp as their "
    "voxels, at the middle of the step and at a tenth of it, and slices with a point spread of .7 of their "
    "distance",
    "the samples of a ball of radius 40 in 96x96x18 floats, slices 6 voxels apart");
  const Volume<float> sharp = ScanBall(0.0);
  const Volume<float> blurred = ScanBall(0.7);
  for (const bool shapeBased : { false, true })
  {
    for (const double smoothing : { 1.0, 2.0, 4.0 })
    {
      const auto angle = [&](const Volume<float>& volume, double isoValue)
      { return AngleOf(SampleBall(volume, isoValue, smoothing, shapeBased)); };
      knob.Add((shapeBased ? "contours, smoothing " : "values, smoothing ") +
          std::to_string(static_cast<int>(smoothing)),
        [&sharp, smoothing, shapeBased] { SampleBall(sharp, 0.5, smoothing, shapeBased); },
        { { "middle", angle(sharp, 0.5) }, { "a tenth", angle(sharp, 0.1) },
          { "blurred", angle(blurred, 0.5) } },
        smoothing == 1.0 && !shapeBased ? Tradeoff::Default : Tradeoff::Choice);
    }
  }
  Tradeoff::PrintHeader();
  knob.Print();
  return 0;
}
