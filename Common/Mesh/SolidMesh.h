// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mesh/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <span>

namespace ink
{

/// Whether a mesh is the surface of solid bodies, so that its inner side is not to be seen: each connected
/// part encloses a positive volume, as its normals say, and holes, if there are any, are no longer around
/// than a fifth of the diagonal of the bounds, as those that scans have. Points that coincide
/// (coincidentPoints) count as one.
/// @param mesh each triangle's points exist; those that have a point that is not finite do not count
/// @param normals one per point
/// @throws std::invalid_argument if there is not one normal per point
bool isSolid(const TriangleMesh& mesh, std::span<const glm::vec3> normals);

} // namespace ink
