// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/PoissonDisk.h"

#include "Core/Hash.h"
#include "Core/ParallelChunks.h"
#include "Core/ParallelFor.h"
#include "Mesh/ScaledPoints.h"
#include "PointSampling/PoissonDiskBins.h"
#include "PointSampling/PoissonDiskBlocks.h"
#include "PointSampling/PoissonDiskGaps.h"
#include "PointSampling/WhiteNoise.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ink
{

namespace
{

// Darts per expected sample, in each of two rounds. After these, filling voids is faster than more darts.
// Without them, blocks would be filled before their neighbors have any samples, which then line up along the
// blocks' sides.
constexpr double dartsPerRound = 0.5;
// A block's side in units of the largest radius. Discs of two blocks of one color must not overlap the same
// bin: each extends by a radius, plus the width of a bin at either end.
constexpr float radiiPerBlock = 16.0f;
// The largest radius, at low density, relative to the smallest.
constexpr double mostStretch = 16.0;

/// A stride that visits 0 to count - 1 in long leaps: near the golden ratio of count, and coprime to it.
std::size_t strideThrough(std::size_t count)
{
  auto stride = static_cast<std::size_t>(0.618 * static_cast<double>(count)) + 1;
  while (std::gcd(stride, count) > 1)
  {
    ++stride;
  }
  return stride;
}

} // namespace

double hexagonalDistance(double area, double count)
{
  return std::sqrt(2.0 * area / (std::numbers::sqrt3 * count));
}

LocalRadius::LocalRadius(const TriangleMesh& mesh, const CumulativeArea& areas, double radius)
  : Constant(!mesh.hasDensity())
  , Scale(radius)
  , Least(radius)
  , Most(radius)
{
  if (this->Constant)
  {
    return;
  }
  float densest = 0.0f;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (areas.area[t + 1] > areas.area[t])
    {
      const glm::vec3 density = mesh.density(t);
      densest = std::max({ densest, density.x, density.y, density.z });
    }
  }
  this->Scale = radius * std::sqrt(areas.mass.back() / areas.area.back());
  this->Least = this->Scale / std::sqrt(static_cast<double>(densest));
  this->Most = mostStretch * this->Least;
}

double LocalRadius::at(float density) const
{
  return this->Constant
    ? this->Least
    : std::clamp(this->Scale / std::sqrt(static_cast<double>(density)), this->Least, this->Most);
}

namespace
{

/// The work on one mesh and radius, round by round.
class Sampling
{
public:
  Sampling(const TriangleMesh& mesh, const CumulativeArea& areas, double radius, std::uint64_t seed)
    : Radii(mesh, areas, radius)
    , Seed(seed)
    , BlockSize(radiiPerBlock * static_cast<float>(this->Radii.most() / this->Radii.least()))
    , Points(scalePoints(mesh, areas, this->Radii.least()).points)
    , Sorted(mesh, this->Points, this->BlockSize)
    , Mesh(this->Sorted.view())
    , Areas(cumulateArea(this->Mesh))
    , LeastRadii(this->radiiOfTriangles())
    , Bins(this->Points, this->Mesh.triangles, this->LeastRadii)
  {
  }

  /// Throws darts, uniformly on the mesh. Returns whether to continue.
  bool throwDarts(std::uint64_t round, std::size_t count, const Progress& progress);
  /// Returns whether to continue.
  bool fillGaps(float smallest, const Progress& progress);
  std::vector<SurfaceSample> takeSamples() { return std::move(this->Results); }

private:
  std::vector<float> radiiOfTriangles() const;
  float radiusAt(const SurfaceSample& sample) const;
  std::uint32_t blockAt(const glm::vec3& position)
  {
    return this->Table.at(glm::ivec3(glm::floor(position / this->BlockSize)));
  }
  /// Calls body(index, make) for the contents of each block, color by color, the blocks of a color in
  /// parallel; make(dart) makes a sample.
  template <class Thing, class Body>
  bool inBlocks(const BlockLists<Thing>& lists, const Body& body, const Progress& progress);

  LocalRadius Radii;
  std::uint64_t Seed;
  float BlockSize;
  std::vector<glm::vec3> Points;
  BlockSortedMesh Sorted;
  const TriangleMesh& Mesh; // sorted
  CumulativeArea Areas;
  std::vector<float> LeastRadii;
  PoissonDiskBins Bins;
  BlockTable Table;
  std::vector<SurfaceSample> Results;
};

std::vector<float> Sampling::radiiOfTriangles() const
{
  std::vector<float> radii(this->Mesh.hasDensity() ? this->Mesh.triangles.size() : 0);
  for (std::size_t t = 0; t < radii.size(); ++t)
  {
    const glm::vec3 density = this->Mesh.density(t);
    const float densest = std::max({ density.x, density.y, density.z });
    radii[t] = densest > 0.0f ? static_cast<float>(this->Radii.at(densest) / this->Radii.least()) : 0.0f;
  }
  return radii;
}

float Sampling::radiusAt(const SurfaceSample& sample) const
{
  const float density = densityOf(this->Mesh, sample);
  return density > 0.0f ? static_cast<float>(this->Radii.at(density) / this->Radii.least()) : 0.0f;
}

template <class Thing, class Body>
bool Sampling::inBlocks(const BlockLists<Thing>& lists, const Body& body, const Progress& progress)
{
  std::vector<std::uint32_t> ofColor[8];
  const std::span<const glm::ivec3> blocks = this->Table.blocks();
  for (std::uint32_t block = 0; block < blocks.size(); ++block)
  {
    const glm::ivec3 parity = blocks[block] & 1;
    if (!lists.of(block).empty())
    {
      ofColor[parity.x + 2 * parity.y + 4 * parity.z].push_back(block);
    }
  }
  double done = 0.0;
  for (const std::vector<std::uint32_t>& ids : ofColor)
  {
    const double share = static_cast<double>(ids.size()) / static_cast<double>(blocks.size());
    std::vector<std::vector<SurfaceSample>> made(ids.size());
    const auto fill = [&](std::size_t i)
    {
      this->Bins.with(
        [&](PoissonDiskBins::Workspace& workspace)
        {
          body(lists.of(ids[i]),
            [&](const PoissonDiskDart& dart)
            {
              made[i].push_back({ this->Sorted.idOf(dart.sample.triangle), dart.sample.b1, dart.sample.b2 });
              this->Bins.add({ dart.position, dart.sample.triangle }, dart.radius, workspace);
            });
        });
    };
    if (!parallelFor(ids.size(), fill,
          progress ? [&](double part) { return progress(done + share * part); } : Progress()))
    {
      return false;
    }
    for (const std::vector<SurfaceSample>& samples : made)
    {
      this->Results.insert(this->Results.end(), samples.begin(), samples.end());
    }
    done += share;
  }
  return true;
}

bool Sampling::throwDarts(std::uint64_t round, std::size_t count, const Progress& progress)
{
  const std::span<const double> weights = this->Areas.weights();
  const double last = std::nextafter(weights.back(), 0.0);
  const double step = weights.back() / static_cast<double>(count);
  const std::uint64_t alongSeed = hash(this->Seed, round, 6);
  const std::uint64_t placeSeed = hash(this->Seed, round, 7);
  std::vector<std::vector<std::pair<std::uint32_t, PoissonDiskDart>>> thrown(chunksOf(count));
  parallelForChunks(count,
    [&](std::size_t chunk, std::size_t begin, std::size_t end)
    {
      std::uint32_t triangle = 0;
      for (std::size_t i = begin; i < end; ++i)
      {
        const double sum = std::min((static_cast<double>(i) + unitDouble(hash(alongSeed ^ i))) * step, last);
        triangle = i == begin ? findTriangle(weights, sum) : findTriangle(weights, sum, triangle);
        if (this->Bins.isCovered(triangle))
        {
          continue;
        }
        PoissonDiskDart dart;
        dart.sample = placeInTriangle(this->Mesh, triangle, hash(placeSeed ^ i));
        dart.radius = this->Mesh.hasDensity() ? this->radiusAt(dart.sample) : 1.0f;
        const auto& [a, b, c3] = this->Mesh.triangles[triangle];
        const glm::vec3& origin = this->Points[a];
        dart.position =
          origin + dart.sample.b1 * (this->Points[b] - origin) + dart.sample.b2 * (this->Points[c3] - origin);
        if (dart.radius > 0.0f && !this->Bins.isTaken(triangle, dart.position, dart.radius))
        {
          thrown[chunk].emplace_back(0, dart);
        }
      }
    });
  for (auto& part : thrown)
  {
    for (auto& [block, dart] : part)
    {
      block = this->blockAt(dart.position);
    }
  }
  const BlockLists<PoissonDiskDart> lists(thrown, this->Table.blocks().size());
  return this->inBlocks(
    lists,
    [&](std::span<const PoissonDiskDart> darts, const auto& make)
    {
      // Neighbors in the list are neighbors on the mesh: a long stride keeps consecutive tries apart.
      const std::size_t stride = strideThrough(darts.size());
      for (std::size_t i = 0, next = 0; i < darts.size(); ++i, next = (next + stride) % darts.size())
      {
        const PoissonDiskDart& dart = darts[next];
        if (!this->Bins.isTaken(dart.sample.triangle, dart.position, dart.radius))
        {
          make(dart);
        }
      }
    },
    progress);
}

bool Sampling::fillGaps(float smallest, const Progress& progress)
{
  const std::size_t triangles = this->Mesh.triangles.size();
  std::vector<std::vector<std::pair<std::uint32_t, PoissonDiskBins::Open>>> found(chunksOf(triangles));
  parallelForChunks(triangles,
    [&](std::size_t chunk, std::size_t begin, std::size_t end)
    {
      std::vector<PoissonDiskBins::Open> open;
      for (std::size_t t = begin; t < end; ++t)
      {
        this->Bins.listOpen(static_cast<std::uint32_t>(t), open);
      }
      for (const PoissonDiskBins::Open& bin : open)
      {
        found[chunk].emplace_back(0, bin);
      }
    });
  for (auto& part : found)
  {
    for (auto& [block, bin] : part)
    {
      block = this->blockAt(this->Bins.cornerOf(bin));
    }
  }
  const BlockLists<PoissonDiskBins::Open> lists(found, this->Table.blocks().size());
  const PoissonDiskGaps::RadiusAt radiusAt = this->Mesh.hasDensity() ? [this](const SurfaceSample& sample)
  { return this->radiusAt(sample); }
                                                                     : PoissonDiskGaps::RadiusAt();
  return this->inBlocks(
    lists,
    [&](std::span<const PoissonDiskBins::Open> bins, const auto& make)
    {
      const PoissonDiskGaps::Make makeSample = make;
      PoissonDiskGaps gaps(this->Bins, radiusAt, smallest, makeSample);
      for (const PoissonDiskBins::Open& bin : bins)
      {
        gaps.fill(bin, hash(this->Seed, bin.bin, 4));
      }
    },
    progress);
}

} // namespace

double fittedCount(double slack)
{
  return 0.72 - 0.3 * slack + 0.09 * slack * slack;
}

PoissonDisk samplePoissonDisk(const TriangleMesh& mesh, const CumulativeArea& areas, double radius,
  double slack, std::uint64_t seed, const Progress& progress)
{
  PoissonDisk result;
  result.radius = radius;
  if (areas.weights().empty() || !(areas.weights().back() > 0.0))
  {
    return result;
  }
  Sampling sampling(mesh, areas, radius, seed);
  const auto darts = static_cast<std::size_t>(
    std::ceil(dartsPerRound * saturatedCount * areas.area.back() / (radius * radius)));
  const auto upTo = [&](double begin, double end) -> Progress
  {
    return progress ? [&, begin, end](double done) { return progress(begin + done * (end - begin)); }
                    : Progress();
  };
  result.stopped = !sampling.throwDarts(0, darts, upTo(0.0, 0.2)) ||
    !sampling.throwDarts(1, darts, upTo(0.2, 0.4)) ||
    !sampling.fillGaps(
      static_cast<float>(std::clamp(slack, leastCoverageSlack, largestCoverageSlack)), upTo(0.4, 1.0));
  result.samples = sampling.takeSamples();
  if (result.stopped)
  {
    result.samples.clear();
  }
  return result;
}

} // namespace ink
