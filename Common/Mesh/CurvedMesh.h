// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace ink
{

/// How finely a coarse mesh is divided, in the unit of its points.
struct CurvedMeshOptions
{
  double deviation; ///< edges are divided whose middle is farther than that from the curve between their ends
  double length;    ///< and which are longer than that
  /// From which number on none are divided any more; there may be up to four times as many.
  std::size_t mostTriangles = std::numeric_limits<std::size_t>::max();
};

/// A coarse mesh as the smooth surface that its point normals describe, in the way of PN triangles (Vlachos
/// et al. 2001): edges become cubic curves that are tangent to the surface at both ends, and are halved until
/// they hardly differ from them. The tangents are longer than published (section 3.1), so that the middle of
/// a circle's arc is on the circle: points deviate from a sphere by rounding alone, instead of in the fourth
/// order. Where the sides of an edge have other normals, it stays sharp, and is tangent to both.
struct CurvedMesh
{
  std::vector<glm::dvec3> points; ///< those of the mesh, then one for each end of a halved edge, per side
  std::vector<glm::vec3> normals;
  std::vector<std::array<std::uint32_t, 2>> ends; ///< of each further point, the earlier ones it lies between
  std::vector<Triangle> triangles;                ///< in the order of the mesh's
  std::vector<std::uint32_t> sources;             ///< of each triangle, the mesh's that it is a part of
};

/// Triangles that are degenerate or not finite stay as they are.
/// @param normals one per point of the mesh, unit length or zero; at sharp edges points are repeated with
///   the normals of each side, see FeatureSplit
/// @param progress when it asks to stop, the mesh is as far divided as it is
/// @throws std::invalid_argument if there is not one normal per point
CurvedMesh curveMesh(const TriangleMesh& mesh, std::span<const glm::vec3> normals,
  const CurvedMeshOptions& options, const Progress& progress = {});

} // namespace ink
