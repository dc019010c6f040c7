// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/PoissonDiskCount.h"

#include "PointSampling/ProgressiveOrder.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ink
{

namespace
{

// The relative excess of samples to aim for, and the maximum to remove.
constexpr double aimedAt = 1.02;
constexpr double atMost = 1.08;
constexpr int mostTries = 8;

Progress part(const Progress& progress, double begin, double end)
{
  return progress ? [=](double done) { return progress(begin + done * (end - begin)); } : Progress();
}

} // namespace

bool sortByPriority(const TriangleMesh& mesh, const CumulativeArea& areas, std::span<const glm::vec3> normals,
  std::vector<SurfaceSample>& samples, std::uint64_t seed, const Progress& progress)
{
  std::vector<glm::dvec3> exact(samples.size());
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high(-low);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    exact[i] = positionOf(mesh, samples[i]);
    low = glm::min(low, exact[i]);
    high = glm::max(high, exact[i]);
  }
  const glm::dvec3 extent = high - low;
  const double size = std::max({ extent.x, extent.y, extent.z, std::numeric_limits<double>::min() });
  std::vector<glm::vec3> positions(samples.size());
  std::vector<float> radii(mesh.hasDensity() ? samples.size() : 0);
  const LocalRadius local(mesh, areas, 1.0);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    positions[i] = (exact[i] - low) / size;
    if (!radii.empty())
    {
      radii[i] = static_cast<float>(local.at(densityOf(mesh, samples[i])) / local.most());
    }
  }
  std::vector<glm::vec3> sampleNormals(samples.size());
  if (!samples.empty())
  {
    placeNormals(mesh, normals, samples, std::span(&sampleNormals[0].x, 3 * samples.size()));
  }
  const std::vector<std::uint32_t> order = progressiveOrder(positions, sampleNormals, radii, seed, progress);
  if (order.size() != samples.size())
  {
    return false;
  }
  std::vector<SurfaceSample> sorted(samples.size());
  std::transform(order.begin(), order.end(), sorted.begin(), [&](std::uint32_t i) { return samples[i]; });
  samples = std::move(sorted);
  return true;
}

PoissonDisk samplePoissonDiskCount(const TriangleMesh& mesh, const CumulativeArea& areas,
  std::span<const glm::vec3> normals, std::size_t count, double slack, std::uint64_t seed,
  const Progress& progress)
{
  PoissonDisk result;
  if (count == 0 || areas.weights().empty() || !(areas.weights().back() > 0.0))
  {
    return result;
  }
  const double aim = std::ceil(aimedAt * static_cast<double>(count)) + 1.0;
  const double most = std::ceil(atMost * static_cast<double>(count)) + 3.0;
  double radius = std::sqrt(fittedCount(slack) * areas.area.back() / aim);
  // Boundaries, curvature and small components change the number that fits: a bracket of radii known to give
  // too many and too few.
  double tooSmall = 0.0;
  double tooLarge = std::numeric_limits<double>::infinity();
  for (int attempt = 0; attempt < mostTries; ++attempt)
  {
    PoissonDisk found = samplePoissonDisk(mesh, areas, radius, slack, seed,
      part(progress, 0.5 - 0.5 / (1 << attempt), 0.5 - 0.25 / (1 << attempt)));
    if (found.stopped)
    {
      return found;
    }
    const auto fit = static_cast<double>(found.samples.size());
    const bool enough = found.samples.size() >= count;
    (enough ? tooSmall : tooLarge) = radius;
    if (enough || found.samples.size() > result.samples.size())
    {
      result = std::move(found);
    }
    if (enough && fit <= most)
    {
      break;
    }
    double next = radius * std::sqrt(std::max(fit, 1.0) / aim);
    if (!(next > tooSmall && next < tooLarge))
    {
      next = std::isfinite(tooLarge) ? 0.5 * (tooSmall + tooLarge) : 2.0 * radius;
    }
    radius = next;
  }
  if (!sortByPriority(mesh, areas, normals, result.samples, seed, part(progress, 0.5, 1.0)))
  {
    result.samples.clear();
    result.stopped = true;
    return result;
  }
  result.samples.resize(std::min(count, result.samples.size()));
  return result;
}

} // namespace ink
