// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mesh/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace ink
{

/// A surface in small parts: their centers, and how much of it each stands for.
struct AreaSamples
{
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals; ///< unit; 0: unknown
  std::vector<float> areas;

  std::size_t size() const { return this->positions.size(); }
};

/// A mesh in parts with edges of a length, or smaller ones; not by chance, so that sums over a few parts are
/// exact. Coordinates are (p - center) / unit. Parts of slivers, which have less than a 64th of the area
/// of a square of that edge, may be longer: the center of these is any position in them. Triangles without
/// area, or with a point that is not finite, have none.
/// @param normals one per point of the mesh
/// @param edge in units, above 0
AreaSamples areaSamples(const TriangleMesh& mesh, std::span<const glm::vec3> normals,
  const glm::dvec3& center, double unit, float edge);

/// The same surface with larger parts: those in the same cube of an edge that point in about the same
/// direction are one.
AreaSamples joinSamples(const AreaSamples& samples, float edge);

} // namespace ink
