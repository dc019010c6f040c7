// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mesh/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// The triangles that repeat an earlier one: with the same three corners, wherever they begin and whichever
/// way they run, as files have them that list both sides of a surface. Ascending indices, mostly none.
/// @param triangles by the ids of their corners
std::vector<std::uint32_t> repeatedTriangles(std::span<const Triangle> triangles);

/// The same by the exact positions of the corners: sides of a surface may have points of their own. Those
/// with a coordinate that is no number repeat none.
/// @param triangles of points that exist
std::vector<std::uint32_t> repeatedTriangles(
  std::span<const glm::dvec3> points, std::span<const Triangle> triangles);

/// Removes the elements of ascending indices from an array.
template <class T>
void eraseIndices(std::vector<T>& values, std::span<const std::uint32_t> indices)
{
  std::size_t next = 0;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (next < indices.size() && indices[next] == i)
    {
      ++next;
      continue;
    }
    values[kept++] = values[i];
  }
  values.resize(kept);
}

} // namespace ink
