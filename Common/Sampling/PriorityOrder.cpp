#include "Sampling/PriorityOrder.h"

#include "Sampling/Hash.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace ink
{

namespace
{

constexpr int levelsPerOctave = 6;
// Points nearer to each other than this part of the largest extent are as good as one.
constexpr int octaves = 22;
constexpr int levelCount = levelsPerOctave * octaves;
constexpr std::size_t blockSize = 1 << 10;
// The cosine between normals of different sides of a surface.
constexpr float otherSide = -0.25f;
// The cosine between normals of sheets that lie above each other, at least, and the squared cosine between
// them and the way from one to the other.
constexpr float sameSide = 0.7f;
constexpr float straightUp = 0.64f;

struct Point
{
  glm::vec3 position;
  glm::vec3 normal; // 0: unknown
  float radius;     // at most 1
};

/// Whether two points near in space are not near on the surface.
bool areApart(const Point& a, const Point& b, const glm::vec3& offset, float squaredDistance)
{
  const float likeness = glm::dot(a.normal, b.normal);
  if (likeness < otherSide)
  {
    return true;
  }
  const float up = glm::dot(a.normal, offset);
  const float otherUp = glm::dot(b.normal, offset);
  return likeness > sameSide && std::min(up * up, otherUp * otherUp) > straightUp * squaredDistance;
}

/// The chosen points in cells of a width that halves as the radius does.
class ChosenPoints
{
public:
  explicit ChosenPoints(std::span<const Point> points)
    : Points(points)
  {
  }

  /// Sorts all into cells that radii of up to `width` are looked up in.
  void sortInto(float width)
  {
    this->Scale = 1.0f / width;
    this->Slots.assign(std::bit_ceil(4 * this->Chosen.size() + 64), Slot());
    this->Used = 0;
    for (std::uint32_t i = 0; i < this->Chosen.size(); ++i)
    {
      this->link(i);
    }
  }

  void add(std::uint32_t point)
  {
    this->Chosen.push_back({ point, none });
    if (2 * this->Used >= this->Slots.size())
    {
      this->sortInto(1.0f / this->Scale);
    }
    else
    {
      this->link(static_cast<std::uint32_t>(this->Chosen.size() - 1));
    }
  }

  /// The least distance of a point to chosen ones, in units of the smaller radius of the two; infinite if
  /// that is not below `width`.
  float distance(std::uint32_t index, float width) const
  {
    const Point& point = this->Points[index];
    const float reach = width * point.radius;
    const glm::ivec3 low(glm::floor((point.position - reach) * this->Scale));
    const glm::ivec3 high(glm::floor((point.position + reach) * this->Scale));
    float least = width;
    for (int z = low.z; z <= high.z; ++z)
    {
      for (int y = low.y; y <= high.y; ++y)
      {
        for (int x = low.x; x <= high.x; ++x)
        {
          for (std::uint32_t i = this->Slots[this->slot({ x, y, z })].head; i != none;
               i = this->Chosen[i].next)
          {
            const Point& other = this->Points[this->Chosen[i].point];
            const glm::vec3 offset = other.position - point.position;
            const float squared = glm::dot(offset, offset);
            const float radius = std::min(point.radius, other.radius);
            const float limit = least * radius;
            if (squared < limit * limit && !areApart(point, other, offset, squared))
            {
              least = std::sqrt(squared) / radius;
            }
          }
        }
      }
    }
    return least < width ? least : std::numeric_limits<float>::infinity();
  }

  std::size_t count() const { return this->Chosen.size(); }
  std::vector<std::uint32_t> take() const
  {
    std::vector<std::uint32_t> points;
    points.reserve(this->Chosen.size());
    for (const auto& [point, next] : this->Chosen)
    {
      points.push_back(point);
    }
    return points;
  }

private:
  static constexpr std::uint32_t none = ~0u;
  static constexpr std::uint64_t empty = ~std::uint64_t(0);
  struct Slot
  {
    std::uint64_t key = empty;
    std::uint32_t head = none;
  };
  struct Link
  {
    std::uint32_t point;
    std::uint32_t next;
  };

  static std::uint64_t key(const glm::ivec3& cell)
  {
    constexpr int bits = 21; // more than there are octaves below 2^20, and less than a third of 64
    const glm::uvec3 positive(cell + (1 << (bits - 1)));
    return std::uint64_t(positive.x) << (2 * bits) | std::uint64_t(positive.y) << bits | positive.z;
  }

  std::size_t slot(const glm::ivec3& cell) const
  {
    const std::uint64_t name = key(cell);
    const std::size_t mask = this->Slots.size() - 1;
    std::size_t place = (name * 0x9e3779b97f4a7c15u >> 32) & mask;
    while (this->Slots[place].key != name && this->Slots[place].key != empty)
    {
      place = (place + 1) & mask;
    }
    return place;
  }

  void link(std::uint32_t chosen)
  {
    const glm::ivec3 cell(glm::floor(this->Points[this->Chosen[chosen].point].position * this->Scale));
    Slot& place = this->Slots[this->slot(cell)];
    if (place.key == empty)
    {
      place.key = key(cell);
      ++this->Used;
    }
    this->Chosen[chosen].next = place.head;
    place.head = chosen;
  }

  std::span<const Point> Points;
  std::vector<Link> Chosen;
  std::vector<Slot> Slots;
  std::size_t Used = 0;
  float Scale = 1.0f;
};

bool isFinite(const glm::vec3& point)
{
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

/// All points in random order: neighbours in the order are no neighbours in space.
std::vector<std::uint32_t> shuffled(std::size_t count, std::uint64_t seed)
{
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(count);
  for (std::uint32_t i = 0; i < count; ++i)
  {
    keys[i] = { hash(seed, i, 5), i };
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order(count);
  std::transform(keys.begin(), keys.end(), order.begin(), [](const auto& entry) { return entry.second; });
  return order;
}

} // namespace

std::vector<std::uint32_t> priorityOrder(std::span<const glm::vec3> points,
  std::span<const glm::vec3> normals, std::span<const float> radii, std::uint64_t seed,
  const Progress& progress)
{
  const std::vector<std::uint32_t> random = shuffled(points.size(), seed);
  glm::vec3 low(std::numeric_limits<float>::infinity());
  glm::vec3 high(-low);
  float largest = 0.0f;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (isFinite(points[i]))
    {
      low = glm::min(low, points[i]);
      high = glm::max(high, points[i]);
      largest = std::max(largest, radii.empty() ? 1.0f : radii[i]);
    }
  }
  const glm::vec3 size = high - low;
  const float widest = std::max({ size.x, size.y, size.z });
  const float scale = widest > 0.0f && std::isfinite(widest) ? 1.0f / widest : 1.0f;

  // In the random order, so that memory is read in the order in which points are looked at.
  std::vector<Point> shuffledPoints(points.size());
  std::vector<std::vector<std::uint32_t>> levels(levelCount + 1);
  std::vector<std::uint32_t> rest;
  for (std::uint32_t i = 0; i < points.size(); ++i)
  {
    const std::uint32_t point = random[i];
    if (!isFinite(points[point]))
    {
      rest.push_back(i);
      continue;
    }
    shuffledPoints[i].position = (points[point] - low) * scale;
    shuffledPoints[i].normal =
      normals.empty() || !isFinite(normals[point]) ? glm::vec3(0.0f) : normals[point];
    // What differs more is looked up in too many cells.
    shuffledPoints[i].radius =
      radii.empty() || !(largest > 0.0f) ? 1.0f : std::clamp(radii[point] / largest, 1e-3f, 1.0f);
    levels[0].push_back(i);
  }

  ChosenPoints chosen(shuffledPoints);
  std::vector<int> next(points.size());
  std::size_t seen = 0;
  for (int level = 0; level < levelCount; ++level)
  {
    const float width = 2.0f * std::exp2(-static_cast<float>(level) / levelsPerOctave);
    if (level % levelsPerOctave == 0)
    {
      chosen.sortInto(width);
    }
    const std::vector<std::uint32_t> candidates = std::move(levels[level]);
    levels[level] = {};
    const auto levelAt = [&](float distance)
    {
      const float exact = -levelsPerOctave * std::log2(std::max(0.5f * distance, 1e-30f));
      return std::clamp(static_cast<int>(std::ceil(exact)), level + 1, levelCount);
    };
    // Most are too near to one that was chosen at a larger radius: that can be seen in parallel.
    parallelFor((candidates.size() + blockSize - 1) / blockSize,
      [&](std::size_t block)
      {
        for (std::size_t i = block * blockSize; i < std::min((block + 1) * blockSize, candidates.size()); ++i)
        {
          const float distance = chosen.distance(candidates[i], width);
          next[candidates[i]] = std::isfinite(distance) ? levelAt(distance) : level;
        }
      });
    const std::size_t before = chosen.count();
    for (const std::uint32_t candidate : candidates)
    {
      int other = next[candidate];
      if (other == level)
      {
        const float distance = chosen.count() > before ? chosen.distance(candidate, width)
                                                       : std::numeric_limits<float>::infinity();
        if (!std::isfinite(distance))
        {
          chosen.add(candidate);
          continue;
        }
        other = levelAt(distance);
      }
      levels[other].push_back(candidate);
    }
    seen = chosen.count();
    if (progress && !progress(static_cast<double>(seen) / static_cast<double>(points.size())))
    {
      return {};
    }
  }
  std::vector<std::uint32_t> order = chosen.take();
  order.insert(order.end(), levels[levelCount].begin(), levels[levelCount].end());
  order.insert(order.end(), rest.begin(), rest.end());
  for (std::uint32_t& point : order)
  {
    point = random[point];
  }
  return order;
}

} // namespace ink
