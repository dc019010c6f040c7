// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/ProgressiveOrder.h"

#include "Core/Hash.h"
#include "Core/IsFinite.h"
#include "Core/MortonOrder.h"
#include "Core/ParallelChunks.h"
#include "Core/ParallelFor.h"
#include "Core/ParallelSort.h"
#include "PointSampling/ChosenPoints.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ink
{

namespace
{

constexpr int levelsPerOctave = 12;
// Points closer than this fraction of the largest extent count as coincident.
constexpr int octaves = 22;
constexpr int levelCount = levelsPerOctave * octaves;
constexpr std::size_t pointsPerChunk = 1 << 12;
// The number of points of a block that are tested sequentially before the rest is tested in parallel.
constexpr std::size_t fewInABlock = 64;
constexpr std::uint16_t isChosen = 0xffff;

/// A point's Morton code.
std::uint64_t mortonCodeOf(const glm::vec3& position) // from 0 to 1
{
  return mortonOf(glm::uvec3(position * static_cast<float>(1 << (mortonBits - 1))));
}

/// The points to sort, with neighbors close in memory.
struct SortedPoints
{
  std::vector<DartPoint> points;
  std::vector<std::uint64_t> mortonCodes;
  std::vector<std::uint32_t> ids;     // their original indices
  std::vector<std::uint32_t> chances; // random
  std::vector<std::uint32_t> rest;    // points that are not finite
};

SortedPoints sortPoints(std::span<const glm::vec3> points, std::span<const glm::vec3> normals,
  std::span<const float> radii, std::uint64_t seed)
{
  glm::vec3 low(std::numeric_limits<float>::infinity());
  glm::vec3 high(-low);
  float largest = 0.0f;
  SortedPoints sorted;
  for (std::uint32_t i = 0; i < points.size(); ++i)
  {
    if (isFinite(points[i]))
    {
      low = glm::min(low, points[i]);
      high = glm::max(high, points[i]);
      largest = std::max(largest, radii.empty() ? 1.0f : radii[i]);
      sorted.ids.push_back(i);
    }
    else
    {
      sorted.rest.push_back(i);
    }
  }
  const glm::vec3 size = high - low;
  const float widest = std::max({ size.x, size.y, size.z });
  const float scale = widest > 0.0f && std::isfinite(widest) ? 1.0f / widest : 1.0f;
  const auto scaled = [&](std::uint32_t point)
  { return glm::clamp((points[point] - low) * scale, 0.0f, 1.0f); };

  const std::size_t count = sorted.ids.size();
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(count);
  parallelForEach(count,
    [&](std::size_t i) {
      keys[i] = { mortonCodeOf(scaled(sorted.ids[i])), sorted.ids[i] };
    });
  parallelSort(keys.begin(), keys.end());
  sorted.points.resize(count);
  sorted.mortonCodes.resize(count);
  sorted.chances.resize(count);
  parallelForEach(count,
    [&](std::size_t i)
    {
      const auto [mortonCode, id] = keys[i];
      sorted.mortonCodes[i] = mortonCode;
      sorted.ids[i] = id;
      sorted.chances[i] = static_cast<std::uint32_t>(hash(seed, id, 5) >> 32);
      DartPoint& point = sorted.points[i];
      point.position = scaled(id);
      point.normal = normals.empty() || !isFinite(normals[id]) ? glm::vec3(0.0f) : normals[id];
      // A larger ratio of radii would search too many cells.
      point.radius = radii.empty() || !(largest > 0.0f) ? 1.0f : std::clamp(radii[id] / largest, 1e-3f, 1.0f);
    });
  return sorted;
}

/// Dart throwing at one radius after the other.
class Chooser
{
public:
  explicit Chooser(const SortedPoints& sorted)
    : Sorted(sorted)
    , Chosen(sorted.points, sorted.mortonCodes)
    , Due(sorted.points.size(), 0)
  {
  }

  /// Chooses all points that are far enough from others at a level's radius.
  void choose(int level);
  std::span<const std::uint32_t> order() const { return this->Order; }

private:
  void sortByChance(std::vector<std::uint32_t>& points) const
  {
    std::sort(points.begin(), points.end(),
      [&](std::uint32_t a, std::uint32_t b)
      { return std::pair(this->Sorted.chances[a], a) < std::pair(this->Sorted.chances[b], b); });
  }
  /// Whether a point is far enough from all chosen ones; otherwise schedules its next test.
  bool hasRoom(std::uint32_t point, int level);
  /// The points among some that are far enough from all chosen so far.
  template <class Pick>
  std::vector<std::uint32_t> findRoom(std::size_t count, int level, const Pick& pick);
  void chooseAmong(std::span<const std::uint32_t> candidates, int level, std::vector<std::uint32_t>& chosen);

  const SortedPoints& Sorted;
  ChosenPoints Chosen;
  std::vector<std::uint16_t> Due; // the level at which to test each point again
  std::vector<std::uint32_t> Order;
};

float widthAt(int level)
{
  return 2.0f * std::exp2(-static_cast<float>(level) / levelsPerOctave);
}

bool Chooser::hasRoom(std::uint32_t point, int level)
{
  const float distance = this->Chosen.distance(point, widthAt(level));
  if (!std::isfinite(distance))
  {
    return true;
  }
  const float exact = -levelsPerOctave * std::log2(std::max(0.5f * distance, 1e-30f));
  this->Due[point] =
    static_cast<std::uint16_t>(std::clamp(static_cast<int>(std::ceil(exact)), level + 1, levelCount));
  return false;
}

template <class Pick>
std::vector<std::uint32_t> Chooser::findRoom(std::size_t count, int level, const Pick& pick)
{
  return parallelGather<std::uint32_t>(
    count,
    [&](std::size_t i, std::vector<std::uint32_t>& found)
    {
      if (const std::uint32_t point = pick(i); point != noPoint && this->hasRoom(point, level))
      {
        found.push_back(point);
      }
    },
    pointsPerChunk);
}

void Chooser::choose(int level)
{
  if (level % levelsPerOctave == 0)
  {
    this->Chosen.setOctave(level / levelsPerOctave, this->Order,
      [&](std::uint32_t point) { return this->Due[point] == isChosen; });
  }
  std::vector<std::uint32_t> candidates = this->findRoom(this->Due.size(), level,
    [&](std::size_t i) { return this->Due[i] == level ? static_cast<std::uint32_t>(i) : noPoint; });
  std::vector<std::uint32_t> chosen;
  // In random order, a few of each block at a time: the first ones exclude most others, which is tested in
  // parallel.
  std::uint64_t seen = 0;
  constexpr std::uint64_t all = std::uint64_t(1) << 32;
  while (!candidates.empty())
  {
    std::size_t blocks = 1;
    for (std::size_t i = 1; i < candidates.size(); ++i)
    {
      blocks += this->Chosen.blockOf(candidates[i]) != this->Chosen.blockOf(candidates[i - 1]) ? 1 : 0;
    }
    const double share = static_cast<double>(fewInABlock * blocks) / static_cast<double>(candidates.size());
    const std::uint64_t end =
      share < 1.0 ? seen + static_cast<std::uint64_t>(share * static_cast<double>(all - seen)) + 1 : all;
    std::vector<std::uint32_t> first;
    std::vector<std::uint32_t> others;
    for (const std::uint32_t point : candidates)
    {
      (this->Sorted.chances[point] < end ? first : others).push_back(point);
    }
    this->chooseAmong(first, level, chosen);
    candidates = this->findRoom(others.size(), level, [&](std::size_t i) { return others[i]; });
    seen = end;
  }
  this->sortByChance(chosen);
  this->Order.insert(this->Order.end(), chosen.begin(), chosen.end());
}

void Chooser::chooseAmong(
  std::span<const std::uint32_t> candidates, int level, std::vector<std::uint32_t>& chosen)
{
  std::vector<std::vector<std::uint32_t>> ofColor[ChosenPoints::colors];
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    const std::uint64_t block = this->Chosen.blockOf(candidates[i]);
    auto& blocks = ofColor[block % ChosenPoints::colors];
    if (i == 0 || this->Chosen.blockOf(candidates[i - 1]) != block)
    {
      blocks.emplace_back();
    }
    blocks.back().push_back(candidates[i]);
  }
  for (auto& blocks : ofColor)
  {
    parallelFor(blocks.size(),
      [&](std::size_t b)
      {
        std::vector<std::uint32_t>& points = blocks[b];
        this->sortByChance(points);
        std::erase_if(points,
          [&](std::uint32_t point)
          {
            if (!this->hasRoom(point, level))
            {
              return true;
            }
            this->Chosen.add(point);
            this->Due[point] = isChosen;
            return false;
          });
      });
    for (const std::vector<std::uint32_t>& points : blocks)
    {
      chosen.insert(chosen.end(), points.begin(), points.end());
    }
  }
}

} // namespace

std::vector<std::uint32_t> progressiveOrder(std::span<const glm::vec3> points,
  std::span<const glm::vec3> normals, std::span<const float> radii, std::uint64_t seed,
  const Progress& progress)
{
  const SortedPoints sorted = sortPoints(points, normals, radii, seed);
  Chooser chooser(sorted);
  for (int level = 0; level < levelCount && chooser.order().size() < sorted.points.size(); ++level)
  {
    chooser.choose(level);
    if (progress &&
      !progress(static_cast<double>(chooser.order().size()) / static_cast<double>(points.size())))
    {
      return {};
    }
  }
  std::vector<std::uint32_t> order;
  order.reserve(points.size());
  std::vector<bool> isOrdered(sorted.points.size());
  for (const std::uint32_t point : chooser.order())
  {
    order.push_back(sorted.ids[point]);
    isOrdered[point] = true;
  }
  // Coincident with chosen points.
  for (std::size_t i = 0; i < isOrdered.size(); ++i)
  {
    if (!isOrdered[i])
    {
      order.push_back(sorted.ids[i]);
    }
  }
  order.insert(order.end(), sorted.rest.begin(), sorted.rest.end());
  return order;
}

} // namespace ink
