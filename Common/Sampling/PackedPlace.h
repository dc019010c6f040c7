#pragma once

#include <glm/vec3.hpp>

#include <cstdint>

namespace ink
{

/// A box that places lie in: from `low`, with `scale` times the edges that all boxes have in common. So boxes
/// differ in size but not in proportions, and places in voxels that are much longer than wide are as exact
/// across as along.
struct PlaceBox
{
  glm::vec3 low{ 0.0f };
  float scale = 0.0f;
};

/// Each of a place's coordinates is one of this many and one.
constexpr int packedPlaceSteps = 1023;

/// The smallest box from `low` that reaches `high`.
/// @param edges of the boxes at scale 1, not negative; where one is 0, low and high have to be equal
PlaceBox fitPlaceBox(const glm::vec3& low, const glm::vec3& high, const glm::vec3& edges);

/// A place in ten bits an axis, x in the lowest: the nearest that there is, off by at most half a step, that
/// is scale * edge / (2 * packedPlaceSteps), along each axis. Places beyond the box are moved to it.
std::uint32_t packPlace(const glm::vec3& place, const PlaceBox& box, const glm::vec3& edges);

/// What packPlace made of it. vtkInkStippleMapper's vertex shader does the same.
glm::vec3 unpackPlace(std::uint32_t packed, const PlaceBox& box, const glm::vec3& edges);

} // namespace ink
