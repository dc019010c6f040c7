// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mesh/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// The triangles of a mesh with the first of all points that coincide (coincidentPoints) in place of each, so
/// that seams are closed. Those that have a point that is not finite are left out.
struct WeldedTriangles
{
  /// @param mesh each triangle's points exist; it must stay valid
  explicit WeldedTriangles(const TriangleMesh& mesh);

  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> source; ///< the mesh's own triangle of each

  TriangleMesh mesh() const { return { this->points, this->triangles, {}, {} }; }
  /// Of the bounds of their points; 0 without triangles.
  double diagonal() const;

private:
  std::span<const glm::dvec3> points;
  glm::dvec3 lower{ 0.0 };
  glm::dvec3 upper{ 0.0 };
};

} // namespace ink
