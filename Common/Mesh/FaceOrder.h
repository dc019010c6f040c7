// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mesh/TriangleMesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// Sorts a mesh's triangles by position: lexicographically by the corners of their faces, x before y before
/// z. So a mesh gives the same result for any numbering of its faces and points, and after being merged from
/// pieces.
/// @param firsts the first triangle of each face. The triangles of a face are consecutive and stay in order.
/// @return triangle indices. The sort is stable: faces with the same corners keep their order.
std::vector<std::uint32_t> orderByPosition(std::span<const glm::dvec3> points,
  std::span<const Triangle> triangles, std::span<const std::uint32_t> firsts);

} // namespace ink
