#pragma once

#include "Sampling/TriangleMesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// An order of a mesh's triangles that depends on nothing but where they are: by their faces' corners, x
/// before y before z. So the same mesh gives the same marks however its faces and points are numbered, and
/// after it came in pieces.
/// @param firsts the first triangle of each face. Those of a face stand side by side, and stay so, in order.
/// @return indices of triangles. Faces with the same corners come in the order they have.
std::vector<std::uint32_t> orderByPosition(std::span<const glm::dvec3> points,
  std::span<const Triangle> triangles, std::span<const std::uint32_t> firsts);

} // namespace ink
