// SPDX-License-Identifier: BSD-3-Clause
// Smoothing of iso-surfaces: noise that it removes from normals against thin tubes that it loses, and the
// time that it takes.

#include "Tradeoff.h"

#include "AnalyticFields.h"
#include "HashNoise.h"
#include "IsoSurface/ResampledSamples.h"
#include "SampledVolume.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using namespace ink::testing;
using ink::SmoothingTarget;

constexpr double Noise = 0.05;
constexpr double IsoValue = 0.5;
constexpr double Major = 14.0;

struct Setting
{
  double Smoothing;
  SmoothingTarget Target;
  int Subdivision;
};

/// What a scanner sees of a torus: 1 inside, 0 outside, blurred by a Gaussian of deviation .7, with noise of
/// 5 % of the step.
Volume<float> Scan(const Torus& torus)
{
  const int n = 48;
  const ink::GridGeometry grid({ n, n, 24 }, glm::dvec3(-0.5 * (n - 1), -0.5 * (n - 1), -11.5));
  // The tube's cross section, blurred: exact for a half space, and for a thin tube by its area.
  constexpr double spread = 0.7;
  constexpr int rings = 24;
  constexpr int spokes = 32;
  std::uint64_t index = 0;
  return Volume<float>::from(grid,
    [&](const glm::dvec3& p)
    {
      const double distance = torus.distance(p) + torus.minor;
      double value = 0.0;
      if (distance < torus.minor + 5.0 * spread)
      {
        for (int ring = 0; ring < rings; ++ring)
        {
          const double r = torus.minor * (ring + 0.5) / rings;
          for (int spoke = 0; spoke < spokes; ++spoke)
          {
            const double angle = 2.0 * M_PI * spoke / spokes;
            const double square = r * r + distance * distance - 2.0 * r * distance * std::cos(angle);
            value += r * std::exp(-0.5 * square / (spread * spread));
          }
        }
        value *= torus.minor / rings / spokes / (spread * spread);
      }
      return value + Noise * hashNormal(1, index++);
    });
}

Samples<float> SamplesOf(const Volume<float>& volume, const Setting& setting)
{
  Samples<float> samples;
  const ink::GrowRoom grow = [&](std::size_t count)
  {
    samples.coordinates.resize(3 * count);
    samples.components.resize(3 * count);
    ink::SampleRoom room;
    room.points = samples.coordinates.data();
    room.normals = samples.components.data();
    room.capacity = count;
    return room;
  };
  std::vector<std::size_t> counts;
  const auto resampling =
    ink::makeIsoSurfaceResampling(volume.geometry, setting.Smoothing, setting.Subdivision, setting.Target);
  if (resampling.isIdentity())
  {
    return sampleIsoSurface<float>(volume.field(), IsoValue);
  }
  ink::sampleResampledIsoSurfaces(
    volume.field(), std::span(&IsoValue, 1), {}, {}, resampling, 0, nullptr, grow, counts);
  return samples;
}

/// Mean angle in degrees to the true normals.
double AngleOf(const Samples<float>& samples, const Torus& torus)
{
  double sum = 0.0;
  int count = 0;
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    const glm::dvec3 p = samples.point(n);
    if (std::abs(torus.distance(p)) < 1.0)
    {
      const glm::dvec3 truth = torus.gradient(p);
      sum +=
        std::atan2(glm::length(glm::cross(samples.normal(n), truth)), glm::dot(samples.normal(n), truth));
      ++count;
    }
  }
  return sum / count * 180.0 / M_PI;
}

/// The share of a tube around which there are no samples, in percent.
double LostOf(const Samples<float>& samples, const Torus& torus)
{
  std::vector<char> found(90, 0);
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    const glm::dvec3 p = samples.point(n);
    if (std::abs(torus.distance(p)) < 1.0)
    {
      const double turn = std::atan2(p.y, p.x) / (2.0 * M_PI) + 0.5;
      found[std::min<std::size_t>(
        static_cast<std::size_t>(turn * static_cast<double>(found.size())), found.size() - 1)] = 1;
    }
  }
  return 100.0 * static_cast<double>(std::count(found.begin(), found.end(), 0)) /
    static_cast<double>(found.size());
}

} // namespace

int main()
{
  const Torus thick{ Major, 5.0 };
  const Volume<float> scan = Scan(thick);
  std::vector<std::pair<Torus, Volume<float>>> thin;
  for (const double radius : { 0.9, 1.0, 1.2, 1.5 })
  {
    const Torus torus{ Major, radius };
    thin.emplace_back(torus, Scan(torus));
  }
  Tradeoff knob("Smoothing (vtkInkIsoSurfaceSampler)",
    "Take what the noise asks for (ink::suggestSmoothing), and smooth the normals rather than the surface, "
    "which loses tubes "
    "of two voxels before their noise is gone.",
    "angle: mean angle to the true normal of a torus with 5 % noise, degrees; lost: of tubes with radii of "
    "0.9, "
    "1, 1.2 and 1.5 voxels, percent",
    "the samples of a torus in 48x48x24 floats");
  const auto add = [&](const std::string& name, const Setting& setting, Tradeoff::Role role)
  {
    Tradeoff::Errors errors = { { "angle", AngleOf(SamplesOf(scan, setting), thick) } };
    double lost = 0.0;
    for (const auto& [torus, volume] : thin)
    {
      lost += LostOf(SamplesOf(volume, setting), torus) / static_cast<double>(thin.size());
    }
    errors.emplace_back("lost", lost);
    knob.Add(
      name, [&scan, setting] { SamplesOf(scan, setting); }, errors, role);
  };
  add("none", { 0.0, SmoothingTarget::Surface, 1 }, Tradeoff::Default);
  for (const SmoothingTarget target : { SmoothingTarget::Surface, SmoothingTarget::Normals })
  {
    for (const double smoothing : { 0.5, 0.7, 1.0, 1.4 })
    {
      std::ostringstream name;
      name << (target == SmoothingTarget::Surface ? "surface, " : "normals, ") << smoothing;
      add(name.str(), { smoothing, target, 1 }, Tradeoff::Choice);
    }
  }
  add("normals, 1, cells halved", { 1.0, SmoothingTarget::Normals, 2 }, Tradeoff::Choice);
  Tradeoff::PrintHeader();
  knob.Print();
  return 0;
}
