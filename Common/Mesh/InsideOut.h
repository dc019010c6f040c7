// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mesh/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <span>

namespace ink
{

/// Whether a closed mesh is wound inside out: its triangles run clockwise seen from outside, so that the
/// volume within is negative. Open meshes have no inside and are never so; those with holes count as closed
/// if the area vectors of their triangles, which add up to zero on closed ones, leave less than a tenth of
/// the area. Triangles with a point that is not finite do not count.
bool isInsideOut(const TriangleMesh& mesh);

/// Whether the normals of a surface, closed or open, face inwards: they make the volume within negative, as
/// seen from the middle of its points. Triangles with a point that is not finite do not count.
/// @param normals one per point
/// @throws std::invalid_argument if there is not one normal per point
bool facesInward(const TriangleMesh& mesh, std::span<const glm::vec3> normals);

} // namespace ink
