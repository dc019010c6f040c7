// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Polylines.h"
#include "Curves/Streamlines/StreamlineTracer.h"
#include "Mesh/MeshNavigation.h"

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace ink
{

/// Lines on a mesh, in the order of their priority.
struct Streamlines
{
  Polylines lines;
  /// In [0, 1), ascending, one per line: the share of the length of all lines that lies before it. So the
  /// lines of less than p have about the share p of all ink.
  std::vector<float> priorities;
  std::vector<MeshPoint> points;     ///< one per point, as all that follow
  std::vector<glm::dvec3> positions; ///< of the points
  std::vector<double> arcLength;     ///< from the line's first point, in world units
};

/// Puts traced lines together in the order of `order`.
Streamlines joinLines(std::span<const TracedLine> lines, std::span<const std::uint32_t> order);

/// The unit normals at points of a mesh: those of its points, interpolated, or where there are none or they
/// cancel out, of its triangles.
/// @param normals of unit length, one per point of the mesh, or empty
std::vector<glm::vec3> normalsAt(
  const MeshNavigation& mesh, std::span<const glm::vec3> normals, std::span<const MeshPoint> points);

/// One such normal.
glm::vec3 normalAt(const MeshNavigation& mesh, std::span<const glm::vec3> normals, const MeshPoint& point);

} // namespace ink
