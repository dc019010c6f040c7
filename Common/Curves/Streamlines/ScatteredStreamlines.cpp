// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Streamlines/ScatteredStreamlines.h"

#include "Core/Hash.h"
#include "Core/ParallelChunks.h"
#include "Core/ParallelSort.h"
#include "Mesh/OnePerPoint.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace ink
{

std::vector<MeshPoint> areaSeeds(
  const MeshNavigation& mesh, const AreaSeedOptions& options, const Progress& progress)
{
  const TriangleMesh& triangles = mesh.mesh();
  if (!options.curvature.empty())
  {
    checkOnePerPoint(triangles, options.curvature.size(), "curvatures");
  }
  if (!(options.count >= 0.0 && std::isfinite(options.count)) || options.mostInTriangle < 1 ||
    !(options.factor >= 0.0))
  {
    throw std::invalid_argument("there are to be " + std::to_string(options.count) + " seeds, " +
      std::to_string(options.mostInTriangle) + " in a triangle at most, " + std::to_string(options.factor) +
      " times as many where the surface is curved; expected 0, 1 and 0 or more");
  }
  const auto most = static_cast<std::uint64_t>(options.mostInTriangle);
  const auto seedTriangle = [&](std::uint32_t t, std::vector<MeshPoint>& seeds)
  {
    if (!mesh.isUsable(t))
    {
      return;
    }
    double probability =
      areaOf(triangles, t) / mesh.area() * options.count / static_cast<double>(options.mostInTriangle);
    if (!options.curvature.empty())
    {
      const auto& [a, b, c] = triangles.triangles[t];
      const double mean =
        (static_cast<double>(options.curvature[a]) + static_cast<double>(options.curvature[b]) +
          static_cast<double>(options.curvature[c])) /
        3.0;
      probability *= mean >= options.threshold ? options.factor : 1.0;
    }
    for (std::uint64_t i = 0; i < most; ++i)
    {
      const std::uint64_t random = hash(options.seed, t, i);
      if (unitDouble(random) < probability)
      {
        double first = unitDouble(hash(random, 1));
        double second = unitDouble(hash(random, 2));
        if (first + second > 1.0)
        {
          first = 1.0 - first;
          second = 1.0 - second;
        }
        seeds.push_back({ t, { 1.0 - first - second, first, second } });
      }
    }
  };
  return parallelGather<MeshPoint>(triangles.triangles.size(), seedTriangle, elementsPerChunk, progress);
}

Streamlines scatteredStreamlines(const MeshNavigation& mesh, const LineField& field,
  std::span<const MeshPoint> seeds, const TraceOptions& options, std::uint64_t seed, const Progress& progress)
{
  checkOnePerPoint(mesh.mesh(), field.directions.size(), "directions");
  const StreamlineTracer tracer(mesh, field, options);
  std::vector<TracedLine> lines(seeds.size());
  const bool going = parallelFor(
    seeds.size(),
    [&](std::size_t i)
    { lines[i] = tracer.trace(seeds[i], field.directions[mesh.nearestPoint(seeds[i])], {}); },
    progress);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
  for (std::uint32_t i = 0; going && i < lines.size(); ++i)
  {
    if (lines[i].points.size() > 1)
    {
      keys.emplace_back(hash(seed, i), i);
    }
  }
  parallelSort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order;
  std::transform(
    keys.begin(), keys.end(), std::back_inserter(order), [](const auto& key) { return key.second; });
  return joinLines<MeshPoint>(lines, order);
}

} // namespace ink
