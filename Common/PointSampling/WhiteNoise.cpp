// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/WhiteNoise.h"

#include "Core/Hash.h"
#include "Core/ParallelChunks.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ink
{

namespace
{

constexpr std::size_t samplesPerChunk = 1 << 13;

/// Uniform in a triangle.
void placeEvenly(std::uint64_t random, SurfaceSample& sample)
{
  const float root = std::sqrt(unitFloat(random, 0));
  const float along = unitFloat(random, 1);
  sample.b1 = root * (1.0f - along);
  sample.b2 = root * along;
}

/// With a density that is linear between the corners: a mixture of three densities, each proportional to one
/// corner's barycentric coordinate. Under such a density, the barycentric coordinates are distributed like
/// the four spacings of three uniform numbers, two of them added.
void placeByDensity(glm::vec3 density, std::uint64_t random, SurfaceSample& sample)
{
  const float choice = unitFloat(random, 0) * (density.x + density.y + density.z);
  float sorted[3] = { unitFloat(random, 1), unitFloat(hash(random), 0), unitFloat(hash(random), 1) };
  std::sort(sorted, sorted + 3);
  const float joined = sorted[1];
  const float third = sorted[2] - sorted[1];
  const float fourth = 1.0f - sorted[2];
  if (choice < density.x)
  {
    sample.b1 = third;
    sample.b2 = fourth;
  }
  else if (choice < density.x + density.y)
  {
    sample.b1 = joined;
    sample.b2 = third;
  }
  else
  {
    sample.b1 = third;
    sample.b2 = joined;
  }
}

} // namespace

SurfaceSample placeInTriangle(const TriangleMesh& mesh, std::uint32_t triangle, std::uint64_t random)
{
  SurfaceSample sample{ triangle, 0.0f, 0.0f };
  if (mesh.pointDensity.empty())
  {
    placeEvenly(random, sample);
  }
  else
  {
    placeByDensity(mesh.density(triangle), random, sample);
  }
  return sample;
}

std::vector<SurfaceSample> sampleWhiteNoise(const TriangleMesh& mesh, const CumulativeArea& areas,
  std::size_t count, std::uint64_t seed, const Progress& progress)
{
  const std::span<const double> weights = areas.weights();
  const double total = weights.empty() ? 0.0 : weights.back();
  if (count == 0 || !(total > 0.0))
  {
    return {};
  }
  // Two streams of random numbers: one for the spacings, one for the positions inside triangles.
  const std::uint64_t spacingSeed = hash(seed, 1);
  const std::uint64_t placeSeed = hash(seed, 2);
  std::vector<double> sums(count + 1); // one more spacing than samples
  std::vector<double> before(chunksOf(count + 1, samplesPerChunk) + 1);
  bool going = parallelForChunks(
    count + 1,
    [&](std::size_t chunk, std::size_t begin, std::size_t end)
    {
      double sum = 0.0;
      for (std::size_t i = begin; i < end; ++i)
      {
        // In (0, 1], so that the logarithm is finite.
        sum -= std::log(1.0 - unitDouble(hash(spacingSeed ^ i)));
        sums[i] = sum;
      }
      before[chunk + 1] = sum;
    },
    samplesPerChunk, progress ? [&](double done) { return progress(0.5 * done); } : Progress());
  if (!going)
  {
    return {};
  }
  std::partial_sum(before.begin(), before.end(), before.begin());
  const double scale = total / before.back();

  std::vector<SurfaceSample> samples(count);
  going = parallelForChunks(
    count,
    [&](std::size_t chunk, std::size_t begin, std::size_t end)
    {
      std::uint32_t triangle = 0;
      for (std::size_t i = begin; i < end; ++i)
      {
        const double sum = std::min((before[chunk] + sums[i]) * scale, std::nextafter(total, 0.0));
        triangle = i == begin ? findTriangle(weights, sum) : findTriangle(weights, sum, triangle);
        samples[i] = placeInTriangle(mesh, triangle, hash(placeSeed ^ i));
      }
    },
    samplesPerChunk, progress ? [&](double done) { return progress(0.5 + 0.5 * done); } : Progress());
  return going ? samples : std::vector<SurfaceSample>();
}

std::vector<SurfaceSample> sampleWhiteNoise(const TriangleMesh& mesh, std::span<const std::uint64_t> ids,
  double perArea, std::uint64_t seed, const Progress& progress)
{
  return parallelGather<SurfaceSample>(
    ids.size(),
    [&](std::size_t t, std::vector<SurfaceSample>& found)
    {
      const double exact = areaOf(mesh, t) * perArea;
      const auto count = static_cast<std::uint64_t>(std::floor(exact + unitDouble(hash(seed, ids[t], 1))));
      for (std::uint64_t i = 0; i < count; ++i)
      {
        SurfaceSample sample{ static_cast<std::uint32_t>(t), 0.0f, 0.0f };
        placeEvenly(hash(hash(seed, ids[t], 2), i), sample);
        found.push_back(sample);
      }
    },
    samplesPerChunk, progress);
}

} // namespace ink
