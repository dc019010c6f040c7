// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Hash.h"
#include "Core/ParallelChunks.h"
#include "Core/ParallelFor.h"
#include "Core/ParallelSort.h"
#include "Core/Progress.h"
#include "Mesh/SurfaceBlocks.h"
#include "PointSampling/CandidatePoints.h"
#include "PointSampling/WhiteNoise.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace ink
{

namespace progressive
{

inline constexpr int levelsPerOctave = 12;
// A block's side in units of an octave's largest radius; at least three, see SurfaceBlocks. Larger blocks
// repeat less work, but outgrow the caches.
inline constexpr float radiiPerBlock = 32.0f;
// A rank is a level, with random lower bits.
inline constexpr int chanceBits = 22;
// The minimum number of samples assumed per octave, so that the first octaves have enough candidates on any
// mesh.
inline constexpr double fewestPerOctave = 8.0;

} // namespace progressive

/// Progressive blue noise on the pieces of a surface, by dart throwing with a radius that shrinks by a
/// twelfth of an octave at a time (McCool and Fiume 1992, section 3), with new random candidates for each
/// octave. The samples do not depend on the number of threads; see sampleProgressively, which says more.
///
/// Pieces, SurfacePieces say, have numbers, in which neighbors on the surface are mostly close, and each has
///   areas(), middles()      relative areas and positions, one per piece
///   ids()                   of each piece, whatever other pieces there are, or none
///   frame(piece)            origin, two axes along the surface, unit normal
///   coordinates(u, v)       of two uniform random numbers: a uniform position along a frame's axes
///   sample(spaced)          what is asked for of a SpacedSample
///   longest()               no piece has two positions farther apart
/// Lengths are in units of the smallest radius that is planned.
///
/// With ids each piece has its own candidates, which depend on nothing else, so that a surface that changes
/// a little keeps most of its samples. Without, candidates are stratified: where pieces are large, they are
/// more even.
template <class Pieces>
class ProgressiveSampler
{
public:
  /// @param pieces kept as a reference
  /// @param widest the diagonal of a box around all pieces
  ProgressiveSampler(const Pieces& pieces, float widest, std::uint64_t seed)
    : Surface(pieces)
    , Octaves(std::max(static_cast<int>(std::ceil(std::log2(widest))), 1))
    , Seed(seed)
  {
    if (pieces.ids().empty())
    {
      this->All.resize(pieces.areas().size());
      std::iota(this->All.begin(), this->All.end(), 0u);
    }
    this->Area = std::accumulate(pieces.areas().begin(), pieces.areas().end(), 0.0);
  }

  /// Down to the unit.
  int octaves() const { return this->Octaves; }
  /// Adds samples at the next radii. Returns whether to continue.
  /// @param levels the number of radii, at most an octave
  /// @param candidates the number of candidates
  bool add(int levels, double candidates, const Progress& progress);
  std::size_t count() const { return this->Samples.size(); }
  /// Sorted by rank, with the pieces' samples as elements.
  auto take();

private:
  float radiusAt(int level) const
  {
    return std::exp2(
      static_cast<float>(this->Octaves) - static_cast<float>(level) / progressive::levelsPerOctave);
  }
  using Made = std::vector<std::vector<SpacedSample>>; // in each block
  using Frame = decltype(std::declval<const Pieces&>().frame(0));
  std::uint64_t seedOfLevel() const { return hash(this->Seed, static_cast<std::uint32_t>(this->Level), 8); }
  /// The number of a piece's own candidates, by its id.
  /// @param seed seedOfLevel()
  /// @param density candidates per area
  std::uint64_t countOwn(std::uint32_t piece, std::uint64_t seed, double density) const
  {
    const double chance = unitDouble(hash(seed ^ this->Surface.ids()[piece]));
    return static_cast<std::uint64_t>(this->Surface.areas()[piece] * density + chance);
  }
  std::vector<std::uint32_t> choosePieces(double density) const;
  static SpacedSample makeCandidate(std::uint32_t piece, const Frame& frame, std::uint64_t random);
  void addStratified(
    const SurfaceBlocks& blocks, std::size_t block, double step, CandidatePoints& candidates) const;
  void addOwn(
    const SurfaceBlocks& blocks, std::size_t block, double density, CandidatePoints& candidates) const;
  void fill(const SurfaceBlocks& blocks, std::size_t block, std::span<const float> radii, double step,
    CandidatePoints& candidates, Made& made) const;

  const Pieces& Surface;
  int Octaves;
  std::uint64_t Seed;
  double Area = 0.0;
  std::vector<std::uint32_t> All; // pieces, if they have no ids
  int Level = 0;                  // the number of radii done
  std::vector<SpacedSample> Samples;
};

/// The pieces with ids that have candidates.
template <class Pieces>
std::vector<std::uint32_t> ProgressiveSampler<Pieces>::choosePieces(double density) const
{
  const std::uint64_t seed = this->seedOfLevel();
  return parallelSelect(this->Surface.ids().size(),
    [&](std::size_t i) { return this->countOwn(static_cast<std::uint32_t>(i), seed, density) > 0; });
}

template <class Pieces>
SpacedSample ProgressiveSampler<Pieces>::makeCandidate(
  std::uint32_t piece, const Frame& frame, std::uint64_t random)
{
  const std::uint64_t more = hash(random);
  const glm::vec2 b = Pieces::coordinates(unitFloat(random, 0), unitFloat(more, 0));
  return { frame.origin + b.x * frame.along1 + b.y * frame.along2, frame.normal, piece, b.x, b.y,
    static_cast<std::uint32_t>(more) >> (32 - progressive::chanceBits) };
}

template <class Pieces>
void ProgressiveSampler<Pieces>::addStratified(
  const SurfaceBlocks& blocks, std::size_t block, double step, CandidatePoints& candidates) const
{
  const std::span<const double> areas = blocks.areas(block);
  const std::span<const std::uint32_t> pieces = blocks.pieces(block);
  const std::uint64_t seed = this->seedOfLevel();
  std::uint32_t piece = 0;
  auto frame = this->Surface.frame(pieces[piece]);
  // One candidate per equal step of the cumulative area.
  const auto last = static_cast<std::uint64_t>(areas.back() / step);
  for (auto i = static_cast<std::uint64_t>(areas.front() / step); i <= last; ++i)
  {
    const std::uint64_t random = hash(seed ^ i);
    const double area = (static_cast<double>(i) + unitFloat(random, 1)) * step;
    if (!(area >= areas.front() && area < areas.back()))
    {
      continue;
    }
    if (areas[piece + 1] <= area)
    {
      piece = findTriangle(areas, area, piece);
      frame = this->Surface.frame(pieces[piece]);
    }
    candidates.add(makeCandidate(pieces[piece], frame, random));
  }
}

template <class Pieces>
void ProgressiveSampler<Pieces>::addOwn(
  const SurfaceBlocks& blocks, std::size_t block, double density, CandidatePoints& candidates) const
{
  const std::uint64_t seed = this->seedOfLevel();
  for (const std::uint32_t piece : blocks.pieces(block))
  {
    const auto frame = this->Surface.frame(piece);
    for (std::uint64_t i = this->countOwn(piece, seed, density); i > 0; --i)
    {
      candidates.add(makeCandidate(piece, frame, hash(seed, this->Surface.ids()[piece], i)));
    }
  }
}

template <class Pieces>
void ProgressiveSampler<Pieces>::fill(const SurfaceBlocks& blocks, std::size_t block,
  std::span<const float> radii, double step, CandidatePoints& candidates, Made& made) const
{
  // Of pieces with ids a block may have samples only.
  if (blocks.pieces(block).empty())
  {
    return;
  }
  const auto firstLevel = static_cast<std::uint32_t>(this->Level);
  candidates.clear();
  if (this->Surface.ids().empty())
  {
    this->addStratified(blocks, block, step, candidates);
  }
  else
  {
    this->addOwn(blocks, block, 1.0 / step, candidates);
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
          candidates.keepAway(sample, radii[(sample.rank >> progressive::chanceBits) - firstLevel]);
        }
      }
    });
  candidates.choose(radii,
    [&](const SpacedSample& sample, std::size_t level)
    {
      made[block].push_back(sample);
      made[block].back().rank |= (firstLevel + static_cast<std::uint32_t>(level)) << progressive::chanceBits;
    });
}

template <class Pieces>
bool ProgressiveSampler<Pieces>::add(int levels, double candidates, const Progress& progress)
{
  std::vector<float> radii(static_cast<std::size_t>(levels));
  for (int i = 0; i < levels; ++i)
  {
    radii[static_cast<std::size_t>(i)] = this->radiusAt(this->Level + i + 1);
  }
  const float side = std::max({ progressive::radiiPerBlock * this->radiusAt(this->Level),
    progressive::radiiPerBlock, this->Surface.longest() / SurfaceBlocks::longestPiece });
  const auto level = static_cast<std::uint64_t>(this->Level);
  const bool hasIds = !this->Surface.ids().empty();
  const double ownStep = this->Area / candidates;
  const std::vector<std::uint32_t> chosen =
    hasIds ? this->choosePieces(1.0 / ownStep) : std::vector<std::uint32_t>();
  const SurfaceBlocks blocks(this->Surface.middles(), this->Surface.areas(), this->Surface.ids(),
    hasIds ? chosen : this->All, side, hash(this->Seed, level, 9), this->Samples);
  std::vector<std::size_t> ofColor[8];
  for (std::size_t block = 0; block < blocks.count(); ++block)
  {
    ofColor[blocks.color(block)].push_back(block);
  }
  tbb::enumerable_thread_specific<CandidatePoints> workspaces;
  Made made(blocks.count());
  // Cumulative areas of blocks end where theirs do.
  const double step = hasIds ? ownStep : blocks.area() / candidates;
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
  std::vector<std::size_t> begins(made.size() + 1, this->Samples.size());
  for (std::size_t block = 0; block < made.size(); ++block)
  {
    begins[block + 1] = begins[block] + made[block].size();
  }
  this->Samples.resize(begins.back());
  parallelFor(made.size(),
    [&](std::size_t block)
    {
      std::copy(made[block].begin(), made[block].end(),
        this->Samples.begin() + static_cast<std::ptrdiff_t>(begins[block]));
      made[block] = {};
    });
  this->Level += levels;
  return true;
}

template <class Pieces>
auto ProgressiveSampler<Pieces>::take()
{
  const std::size_t count = this->Samples.size();
  std::vector<std::uint64_t> order(count);
  parallelForEach(count, [&](std::size_t i) { order[i] = std::uint64_t(this->Samples[i].rank) << 32 | i; });
  parallelSort(order.begin(), order.end());
  std::vector<decltype(this->Surface.sample(this->Samples.front()))> sorted(count);
  parallelForEach(count,
    [&](std::size_t i)
    { sorted[i] = this->Surface.sample(this->Samples[static_cast<std::uint32_t>(order[i])]); });
  return sorted;
}

} // namespace ink
