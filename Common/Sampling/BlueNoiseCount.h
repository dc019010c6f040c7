#pragma once

#include "Sampling/BlueNoise.h"

namespace ink
{

/// A number of blue-noise samples, in the order of priorityOrder: sampleBlueNoise with a radius that gives a
/// few more than asked for, of which those are left out that are nearest to others.
/// @param normals for the order: unit, one a point of the mesh; or none, for those of the triangles
/// @return `count` samples, and the radius that they were made with. Fewer where samples are so crowded that
/// single
///   precision does not tell them apart.
/// Other parameters and errors as for sampleBlueNoise.
BlueNoise sampleBlueNoiseCount(const TriangleMesh& mesh, const CumulativeArea& areas,
  std::span<const glm::vec3> normals, std::size_t count, double gap, std::uint64_t seed,
  const Progress& progress = {});

/// Sorts samples by priorityOrder, with the space around each by the mesh's density. Returns false, and
/// leaves them as they were, when stopped.
bool sortByPriority(const TriangleMesh& mesh, const CumulativeArea& areas, std::span<const glm::vec3> normals,
  std::vector<SurfaceSample>& samples, std::uint64_t seed, const Progress& progress = {});

} // namespace ink
