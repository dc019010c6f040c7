#include "Sampling/PackedPlace.h"

#include <algorithm>
#include <cmath>

namespace ink
{

namespace
{

constexpr int bitsPerAxis = 10;
constexpr std::uint32_t mask = (1u << bitsPerAxis) - 1u;
static_assert(mask == packedPlaceSteps);

} // namespace

PlaceBox fitPlaceBox(const glm::vec3& low, const glm::vec3& high, const glm::vec3& edges)
{
  PlaceBox box{ low, 0.0f };
  for (int axis = 0; axis < 3; ++axis)
  {
    if (edges[axis] > 0.0f)
    {
      box.scale = std::max(box.scale, (high[axis] - low[axis]) / edges[axis]);
    }
  }
  return box;
}

std::uint32_t packPlace(const glm::vec3& place, const PlaceBox& box, const glm::vec3& edges)
{
  std::uint32_t packed = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const float length = box.scale * edges[axis];
    const float share = length > 0.0f ? (place[axis] - box.low[axis]) / length : 0.0f;
    const auto step =
      static_cast<std::uint32_t>(std::lround(std::clamp(share, 0.0f, 1.0f) * packedPlaceSteps));
    packed |= step << (bitsPerAxis * axis);
  }
  return packed;
}

glm::vec3 unpackPlace(std::uint32_t packed, const PlaceBox& box, const glm::vec3& edges)
{
  const glm::vec3 steps(static_cast<float>(packed & mask), static_cast<float>(packed >> bitsPerAxis & mask),
    static_cast<float>(packed >> (2 * bitsPerAxis) & mask));
  return box.low + box.scale * (edges / static_cast<float>(packedPlaceSteps)) * steps;
}

} // namespace ink
