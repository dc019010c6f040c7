#include "Sampling/BlueNoise.h"

#include "Sampling/BlueNoiseBlock.h"
#include "Sampling/Hash.h"
#include "Sampling/SurfaceWalk.h"
#include "Sampling/WhiteNoise.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <unordered_map>

namespace ink
{

namespace
{

// Darts for each sample that is expected. More take time, fewer leave more to the filling of gaps, which
// prefers the small triangles.
constexpr double dartsPerSample = 4.0;
// All blocks get a part of their darts before any gets the next, and gaps are filled last: a block that was
// full before its neighbours have any would have its samples along its sides.
constexpr std::size_t dartRounds = 4;
// The radius at a place of little density is at most this many times the least.
constexpr double mostStretch = 16.0;

/// Which block each thing is in, a list for each block.
class BlockLists
{
public:
  void add(std::uint32_t block, std::uint32_t thing) { this->Pairs.emplace_back(block, thing); }

  void sort(std::size_t blocks)
  {
    this->Begin.assign(blocks + 1, 0);
    for (const auto& [block, thing] : this->Pairs)
    {
      ++this->Begin[block + 1];
    }
    for (std::size_t i = 0; i < blocks; ++i)
    {
      this->Begin[i + 1] += this->Begin[i];
    }
    this->Things.resize(this->Pairs.size());
    std::vector<std::size_t> next(this->Begin.begin(), this->Begin.end() - 1);
    for (const auto& [block, thing] : this->Pairs)
    {
      this->Things[next[block]++] = thing;
    }
    this->Pairs = {};
  }

  std::span<const std::uint32_t> of(std::size_t block) const
  {
    return std::span(this->Things).subspan(this->Begin[block], this->Begin[block + 1] - this->Begin[block]);
  }

private:
  std::vector<std::pair<std::uint32_t, std::uint32_t>> Pairs;
  std::vector<std::uint32_t> Things;
  std::vector<std::size_t> Begin;
};

/// Names the blocks that something lies in.
class BlockTable
{
public:
  static constexpr int bits = 21;

  std::uint32_t at(const glm::ivec3& block)
  {
    // Neighbouring triangles and darts mostly lie in one block.
    if (block == this->LastBlock)
    {
      return this->LastName;
    }
    const auto [entry, isNew] =
      this->Names.emplace(key(block), static_cast<std::uint32_t>(this->Blocks.size()));
    if (isNew)
    {
      this->Blocks.push_back(block);
    }
    this->LastBlock = block;
    this->LastName = entry->second;
    return entry->second;
  }

  /// -1: nothing lies there.
  std::int64_t find(const glm::ivec3& block) const
  {
    const auto entry = this->Names.find(key(block));
    return entry == this->Names.end() ? -1 : static_cast<std::int64_t>(entry->second);
  }

  std::span<const glm::ivec3> blocks() const { return this->Blocks; }

private:
  static std::uint64_t key(const glm::ivec3& block)
  {
    const glm::uvec3 positive(block + (1 << (bits - 1)));
    return std::uint64_t(positive.x) << (2 * bits) | std::uint64_t(positive.y) << bits | positive.z;
  }

  std::unordered_map<std::uint64_t, std::uint32_t> Names;
  std::vector<glm::ivec3> Blocks;
  glm::ivec3 LastBlock{ std::numeric_limits<int>::max() };
  std::uint32_t LastName = 0;
};

/// The mesh's points with the least radius as the unit and the mesh's middle as the origin.
std::vector<glm::vec3> scalePoints(const TriangleMesh& mesh, const CumulativeArea& areas, double unit)
{
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high(-low);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (areas.area[t + 1] > areas.area[t])
    {
      for (const std::uint32_t point : mesh.triangles[t])
      {
        low = glm::min(low, mesh.points[point]);
        high = glm::max(high, mesh.points[point]);
      }
    }
  }
  const glm::dvec3 size = (high - low) / unit;
  const double widest = std::max({ size.x, size.y, size.z });
  if (!(widest < 0x1p24))
  {
    throw std::invalid_argument("the mesh is " + std::to_string(widest) +
      " radii wide; expected fewer than 16777216, so a larger radius or fewer samples");
  }
  const glm::dvec3 middle = 0.5 * (low + high);
  std::vector<glm::vec3> points(mesh.points.size());
  constexpr std::size_t blockSize = 1 << 14;
  parallelFor((points.size() + blockSize - 1) / blockSize,
    [&](std::size_t block)
    {
      for (std::size_t i = block * blockSize; i < std::min((block + 1) * blockSize, points.size()); ++i)
      {
        points[i] = (mesh.points[i] - middle) / unit;
      }
    });
  return points;
}

/// Cuts a triangle into parts that are small against a block, and gives each to the blocks that it may
/// reach into.
void giveOut(const SurfacePart& part, std::vector<SurfacePart>& parts, BlockTable& table, BlockLists& lists)
{
  if (part.reach() > 0.25f * BlueNoiseBlock::size)
  {
    const auto [first, second] = part.halves();
    giveOut(first, parts, table, lists);
    giveOut(second, parts, table, lists);
    return;
  }
  const auto name = static_cast<std::uint32_t>(parts.size());
  parts.push_back(part);
  const auto& [a, b, c] = part.positions;
  const glm::ivec3 low(glm::floor(glm::min(glm::min(a, b), c) / BlueNoiseBlock::size));
  const glm::ivec3 high(glm::floor(glm::max(glm::max(a, b), c) / BlueNoiseBlock::size));
  for (int z = low.z; z <= high.z; ++z)
  {
    for (int y = low.y; y <= high.y; ++y)
    {
      for (int x = low.x; x <= high.x; ++x)
      {
        lists.add(table.at({ x, y, z }), name);
      }
    }
  }
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

BlueNoise sampleBlueNoise(const TriangleMesh& mesh, const CumulativeArea& areas, double radius,
  std::uint64_t seed, const Progress& progress)
{
  BlueNoise result;
  result.radius = radius;
  if (areas.weights().empty() || !(areas.weights().back() > 0.0))
  {
    return result;
  }
  const LocalRadius radii(mesh, areas, radius);
  const double unit = radii.least();
  const std::vector<glm::vec3> points = scalePoints(mesh, areas, unit);
  const SurfaceWalk walk(points, mesh.triangles);
  const auto relativeRadius = [&](float density) { return static_cast<float>(radii.at(density) / unit); };

  BlockTable table;
  BlockLists partLists;
  std::vector<SurfacePart> parts;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const glm::vec3 density = mesh.density(t);
    const float densest = std::max({ density.x, density.y, density.z });
    if (areas.area[t + 1] > areas.area[t] && densest > 0.0f)
    {
      const auto& [a, b, c] = mesh.triangles[t];
      const SurfacePart whole{ t, relativeRadius(densest), { points[a], points[b], points[c] },
        { glm::vec2(0.0f), glm::vec2(1.0f, 0.0f), glm::vec2(0.0f, 1.0f) } };
      giveOut(whole, parts, table, partLists);
    }
  }

  const double expected = saturatedCount * areas.area.back() / (radius * radius);
  const auto dartCount = static_cast<std::size_t>(std::ceil(dartsPerSample * expected)) + 1;
  const std::vector<SurfaceSample> thrown = sampleWhiteNoise(mesh, areas, dartCount, seed);
  std::vector<BlueNoiseDart> darts(thrown.size());
  constexpr std::size_t blockSize = 1 << 13;
  parallelFor((darts.size() + blockSize - 1) / blockSize,
    [&](std::size_t block)
    {
      for (std::size_t i = block * blockSize; i < std::min((block + 1) * blockSize, darts.size()); ++i)
      {
        const SurfaceSample& sample = thrown[i];
        const auto& [a, b, c] = mesh.triangles[sample.triangle];
        darts[i].sample = sample;
        darts[i].position =
          points[a] + sample.b1 * (points[b] - points[a]) + sample.b2 * (points[c] - points[a]);
        darts[i].radius = mesh.hasDensity() ? relativeRadius(densityOf(mesh, sample)) : 1.0f;
      }
    });
  BlockLists dartLists;
  for (std::uint32_t i = 0; i < darts.size(); ++i)
  {
    dartLists.add(table.at(glm::ivec3(glm::floor(darts[i].position / BlueNoiseBlock::size))), i);
  }

  const std::span<const glm::ivec3> blocks = table.blocks();
  partLists.sort(blocks.size());
  dartLists.sort(blocks.size());
  std::vector<std::uint32_t> ofColour[8];
  for (std::uint32_t block = 0; block < blocks.size(); ++block)
  {
    const glm::ivec3 parity = blocks[block] & 1;
    ofColour[parity.x + 2 * parity.y + 4 * parity.z].push_back(block);
  }

  std::vector<std::vector<std::uint32_t>> order(blocks.size());
  parallelFor(blocks.size(),
    [&](std::size_t name)
    {
      std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
      for (const std::uint32_t dart : dartLists.of(name))
      {
        keys.emplace_back(hash(seed, dart, 3), dart);
      }
      std::sort(keys.begin(), keys.end());
      for (const auto& [random, dart] : keys)
      {
        order[name].push_back(dart);
      }
    });

  std::vector<std::vector<BlueNoiseDart>> taken(blocks.size());
  const auto fill = [&](std::uint32_t name, std::size_t round)
  {
    BlueNoiseBlock block(mesh, walk, blocks[name], relativeRadius);
    for (int neighbour = 0; neighbour < 27; ++neighbour)
    {
      const glm::ivec3 offset(neighbour % 3 - 1, neighbour / 3 % 3 - 1, neighbour / 9 - 1);
      if (const std::int64_t other = table.find(blocks[name] + offset); other >= 0)
      {
        block.addSamples(taken[other]);
      }
    }
    if (round < dartRounds)
    {
      const std::size_t begin = order[name].size() * round / dartRounds;
      const std::size_t end = order[name].size() * (round + 1) / dartRounds;
      for (std::size_t i = begin; i < end; ++i)
      {
        block.tryDart(darts[order[name][i]]);
      }
    }
    else
    {
      for (const std::uint32_t part : partLists.of(name))
      {
        block.fillGaps(parts[part], hash(seed, part, 4));
      }
    }
    const std::vector<BlueNoiseDart> made = block.takeDarts();
    taken[name].insert(taken[name].end(), made.begin(), made.end());
  };
  double done = 0.0;
  for (std::size_t round = 0; round <= dartRounds; ++round)
  {
    for (const std::vector<std::uint32_t>& names : ofColour)
    {
      const double share =
        static_cast<double>(names.size()) / static_cast<double>((dartRounds + 1) * blocks.size());
      if (!parallelFor(
            names.size(), [&](std::size_t i) { fill(names[i], round); },
            progress ? [&](double part) { return progress(done + share * part); } : Progress()))
      {
        result.stopped = true;
        return result;
      }
      done += share;
    }
  }
  for (const std::vector<BlueNoiseDart>& ofBlock : taken)
  {
    for (const BlueNoiseDart& dart : ofBlock)
    {
      result.samples.push_back(dart.sample);
    }
  }
  return result;
}

} // namespace ink
