// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mesh/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <array>
#include <span>
#include <vector>

namespace ink
{

/// The vectors from a sample to the nearest position on a sharp edge that bounds its side of the surface, and
/// to the nearest in another direction, as across a thin wall. Zero: there is none within reach.
using EdgeOffsets = std::array<glm::vec3, 2>;

/// Where discs around samples have to end, so as not to reach over sharp edges.
///
/// Sharp edges are the creases that are drawn as lines (FeatureEdges, sharpOnly, with defaultFeatureAngle and
/// defaultShortestCrease), as elsewhere discs show what is bent. Borders are none, so that discs close the
/// holes of scans.
/// @param normals one per point, unit length or zero
/// @param reach in world units, above 0
/// @return one per sample; none if there are no sharp edges
std::vector<EdgeOffsets> edgeOffsets(const TriangleMesh& mesh, std::span<const glm::vec3> normals,
  std::span<const SurfaceSample> samples, double reach);

} // namespace ink
