// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/ProgressiveBlueNoise.h"

#include "Mesh/ScaledPoints.h"
#include "Mesh/SurfacePieces.h"
#include "PointSampling/ProgressiveSampler.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ink
{

namespace
{

// The relative excess of samples to aim for.
constexpr double progressiveExcess = 1.02;
// Radii down to 1/256 of the expected one are tried.
constexpr int mostLevelsMore = 8 * progressive::levelsPerOctave;

} // namespace

double progressiveCount(double candidates)
{
  return 0.7 - 0.371 * std::pow(candidates, -0.37);
}

std::vector<SurfaceSample> sampleProgressively(const TriangleMesh& mesh, const CumulativeArea& areas,
  std::span<const glm::vec3> normals, std::size_t count, double candidates, std::uint64_t seed,
  const Progress& progress)
{
  if (count == 0 || areas.area.empty() || !(areas.area.back() > 0.0))
  {
    return {};
  }
  const double each = std::clamp(candidates, leastCandidates, mostCandidates);
  const double aim = progressiveExcess * static_cast<double>(count) + 1.0;
  const ScaledPoints scaled =
    scalePoints(mesh, areas, std::sqrt(progressiveCount(each) * areas.area.back() / aim));
  const SurfacePieces pieces(
    mesh, scaled.points, normals, SurfaceBlocks::longestPiece * progressive::radiiPerBlock);
  // The diagonal of the mesh's bounds.
  ProgressiveSampler sampler(pieces, static_cast<float>(std::numbers::sqrt3 * scaled.widest), seed);
  const auto part = [&](double begin, double end) -> Progress
  {
    return progress ? [&, begin, end](double done) { return progress(begin + done * (end - begin)); }
                    : Progress();
  };
  for (int octave = sampler.octaves() - 1; octave >= 0; --octave)
  {
    const double share = std::ldexp(1.0, -2 * octave);
    if (!sampler.add(progressive::levelsPerOctave, each * std::max(aim * share, progressive::fewestPerOctave),
          part(0.2375 * share, 0.95 * share)))
    {
      return {};
    }
  }
  // Curvature, boundaries and small components change the number that fits.
  for (int level = 0; sampler.count() < count && level < mostLevelsMore;)
  {
    const double missing =
      static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(sampler.count(), 1));
    const int levels =
      std::clamp(static_cast<int>(std::ceil(0.5 * progressive::levelsPerOctave * std::log2(missing))), 1,
        progressive::levelsPerOctave - level % progressive::levelsPerOctave);
    if (!sampler.add(levels, each * aim, part(0.95, 1.0)))
    {
      return {};
    }
    level += levels;
  }
  std::vector<SurfaceSample> samples = sampler.take();
  samples.resize(std::min(count, samples.size()));
  return samples;
}

} // namespace ink
