// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// Samples of a surface, group by group.
struct SampleGroups
{
  std::vector<std::uint32_t> samples; ///< in each group ascending, and so still in progressive order
  std::vector<std::size_t> begins;    ///< the first of each group; one more entry, the number of samples
};

/// Groups of neighbors on one side of a surface, as the polygons of a mesh would make them: those in the same
/// cube whose normals point in about the same direction, one of 24 (the octants of the faces of a cube around
/// the origin). So a list of stipples is made of samples that have none. Groups are in Morton order of their
/// cubes, the same for any number of threads.
/// @param positions fewer than 2^32, finite
/// @param normals one per position
/// @param edge of a cube, above 0; about the origin up to 2^20 to either side of it
SampleGroups groupSamples(
  std::span<const glm::vec3> positions, std::span<const glm::vec3> normals, float edge);

/// The edge of the cubes with which groups have so many samples, on average over the orientations of a plane:
/// a cube that a plane crosses has 2/3 of the area of one of its faces.
/// @param area of the surface per sample
float groupEdge(double area, double samples);

} // namespace ink
