// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/ProgressiveBlueNoise.h"

#include "Core/Hash.h"
#include "Core/ParallelFor.h"
#include "Core/ParallelSort.h"
#include "Core/ScaledPoints.h"
#include "Mesh/SurfaceBlocks.h"
#include "Mesh/SurfacePieces.h"
#include "PointSampling/CandidatePoints.h"
#include "PointSampling/WhiteNoise.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace ink
{

namespace
{

constexpr int levelsPerOctave = 12;
// A block's side in units of an octave's largest radius; at least three, see SurfaceBlocks. Larger blocks
// repeat less work, but outgrow the caches.
constexpr float radiiPerBlock = 32.0f;
// A rank is a level, with random lower bits.
constexpr int chanceBits = 22;
// The relative excess of samples to aim for.
constexpr double aimedAt = 1.02;
// The minimum number of samples assumed per octave, so that the first octaves have enough candidates on any
// mesh.
constexpr double fewest = 8.0;
// Radii down to 1/256 of the expected one are tried.
constexpr int mostLevelsMore = 8 * levelsPerOctave;

/// The work on one mesh. Lengths are in units of the radius that is expected to give all samples.
class Sampler
{
public:
  Sampler(const TriangleMesh& mesh, std::span<const glm::vec3> points, std::span<const glm::vec3> normals,
    float widest, std::uint64_t seed)
    : Pieces(mesh, points, normals, SurfaceBlocks::longestPiece * radiiPerBlock)
    , Octaves(std::max(static_cast<int>(std::ceil(std::log2(widest))), 1))
    , Seed(seed)
  {
  }

  /// Down to the unit.
  int octaves() const { return this->Octaves; }
  /// Adds samples at the next radii. Returns whether to continue.
  /// @param levels the number of radii, at most an octave
  /// @param candidates the number of candidates
  bool add(int levels, double candidates, const Progress& progress);
  std::size_t count() const { return this->Samples.size(); }
  /// Sorted by rank.
  std::vector<SurfaceSample> take();

private:
  float radiusAt(int level) const
  {
    return std::exp2(static_cast<float>(this->Octaves) - static_cast<float>(level) / levelsPerOctave);
  }
  using Made = std::vector<std::vector<SpacedSample>>; // in each block
  void fill(const SurfaceBlocks& blocks, std::size_t block, std::span<const float> radii, double step,
    CandidatePoints& candidates, Made& made) const;

  SurfacePieces Pieces;
  int Octaves;
  std::uint64_t Seed;
  int Level = 0; // the number of radii done
  std::vector<SpacedSample> Samples;
};

void Sampler::fill(const SurfaceBlocks& blocks, std::size_t block, std::span<const float> radii, double step,
  CandidatePoints& candidates, Made& made) const
{
  const std::span<const double> areas = blocks.areas(block);
  const std::span<const std::uint32_t> pieces = blocks.pieces(block);
  const auto firstLevel = static_cast<std::uint32_t>(this->Level);
  const std::uint64_t seed = hash(this->Seed, firstLevel, 8);
  candidates.clear();
  std::uint32_t piece = 0;
  SurfacePieces::Frame frame = this->Pieces.frame(pieces[piece]);
  // Stratified: one candidate per equal step of the cumulative area.
  const auto last = static_cast<std::uint64_t>(areas.back() / step);
  for (auto i = static_cast<std::uint64_t>(areas.front() / step); i <= last; ++i)
  {
    const std::uint64_t random = hash(seed ^ i);
    const double place = (static_cast<double>(i) + unitFloat(random, 1)) * step;
    if (!(place >= areas.front() && place < areas.back()))
    {
      continue;
    }
    if (areas[piece + 1] <= place)
    {
      piece = findTriangle(areas, place, piece);
      frame = this->Pieces.frame(pieces[piece]);
    }
    const float root = std::sqrt(unitFloat(random, 0));
    const std::uint64_t more = hash(random);
    const float b2 = root * unitFloat(more, 0);
    const float b1 = root - b2;
    candidates.add({ frame.origin + b1 * frame.along1 + b2 * frame.along2, frame.normal, pieces[piece], b1,
      b2, static_cast<std::uint32_t>(more) >> (32 - chanceBits) });
  }
  const float widest = this->radiusAt(this->Level);
  candidates.sort(widest);
  const glm::vec3 low = candidates.low() - widest;
  const glm::vec3 high = candidates.high() + widest;
  const auto isNear = [&](const SpacedSample& sample)
  {
    const glm::vec3& p = sample.position;
    return p.x > low.x && p.y > low.y && p.z > low.z && p.x < high.x && p.y < high.y && p.z < high.z;
  };
  blocks.visitAround(block,
    [&](std::size_t other)
    {
      for (const SpacedSample& sample : blocks.samples(other))
      {
        if (isNear(sample))
        {
          candidates.keepAway(sample, widest);
        }
      }
      for (const SpacedSample& sample : made[other])
      {
        if (isNear(sample))
        {
          candidates.keepAway(sample, radii[(sample.rank >> chanceBits) - firstLevel]);
        }
      }
    });
  candidates.choose(radii,
    [&](const SpacedSample& sample, std::size_t level)
    {
      made[block].push_back(sample);
      made[block].back().rank |= (firstLevel + static_cast<std::uint32_t>(level)) << chanceBits;
    });
}

bool Sampler::add(int levels, double candidates, const Progress& progress)
{
  std::vector<float> radii(static_cast<std::size_t>(levels));
  for (int i = 0; i < levels; ++i)
  {
    radii[static_cast<std::size_t>(i)] = this->radiusAt(this->Level + i + 1);
  }
  const float side = std::max(radiiPerBlock * this->radiusAt(this->Level), radiiPerBlock);
  const auto level = static_cast<std::uint64_t>(this->Level);
  const SurfaceBlocks blocks(this->Pieces, side, hash(this->Seed, level, 9), this->Samples);
  std::vector<std::size_t> ofColor[8];
  for (std::size_t block = 0; block < blocks.count(); ++block)
  {
    ofColor[blocks.color(block)].push_back(block);
  }
  tbb::enumerable_thread_specific<CandidatePoints> workspaces;
  Made made(blocks.count());
  const double step = blocks.area() / candidates;
  double done = 0.0;
  for (const std::vector<std::size_t>& some : ofColor)
  {
    const double share = static_cast<double>(some.size()) / static_cast<double>(blocks.count());
    if (!parallelFor(
          some.size(),
          [&](std::size_t i) { this->fill(blocks, some[i], radii, step, workspaces.local(), made); },
          progress ? [&](double part) { return progress(done + share * part); } : Progress()))
    {
      return false;
    }
    done += share;
  }
  const auto added = std::accumulate(made.begin(), made.end(), this->Samples.size(),
    [](std::size_t sum, const std::vector<SpacedSample>& samples) { return sum + samples.size(); });
  this->Samples.reserve(added);
  for (std::vector<SpacedSample>& samples : made)
  {
    this->Samples.insert(this->Samples.end(), samples.begin(), samples.end());
    samples = {};
  }
  this->Level += levels;
  return true;
}

std::vector<SurfaceSample> Sampler::take()
{
  const std::size_t count = this->Samples.size();
  std::vector<std::uint64_t> order(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    order[i] = std::uint64_t(this->Samples[i].rank) << 32 | i;
  }
  parallelSort(order.begin(), order.end());
  std::vector<SurfaceSample> sorted(count);
  constexpr std::size_t chunk = 1 << 14;
  parallelFor((count + chunk - 1) / chunk,
    [&](std::size_t c)
    {
      for (std::size_t i = c * chunk; i < std::min((c + 1) * chunk, count); ++i)
      {
        const SpacedSample& sample = this->Samples[static_cast<std::uint32_t>(order[i])];
        sorted[i] = this->Pieces.sample(sample.piece, sample.b1, sample.b2);
      }
    });
  return sorted;
}

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
  const double aim = aimedAt * static_cast<double>(count) + 1.0;
  const ScaledPoints scaled =
    scalePoints(mesh, areas, std::sqrt(progressiveCount(each) * areas.area.back() / aim));
  // The diagonal of the mesh's bounds.
  Sampler sampler(
    mesh, scaled.points, normals, static_cast<float>(std::numbers::sqrt3 * scaled.widest), seed);
  const auto part = [&](double begin, double end) -> Progress
  {
    return progress ? [&, begin, end](double done) { return progress(begin + done * (end - begin)); }
                    : Progress();
  };
  for (int octave = sampler.octaves() - 1; octave >= 0; --octave)
  {
    const double share = std::ldexp(1.0, -2 * octave);
    if (!sampler.add(
          levelsPerOctave, each * std::max(aim * share, fewest), part(0.2375 * share, 0.95 * share)))
    {
      return {};
    }
  }
  // Curvature, boundaries and small components change the number that fits.
  for (int level = 0; sampler.count() < count && level < mostLevelsMore;)
  {
    const double missing =
      static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(sampler.count(), 1));
    const int levels = std::clamp(static_cast<int>(std::ceil(0.5 * levelsPerOctave * std::log2(missing))), 1,
      levelsPerOctave - level % levelsPerOctave);
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
