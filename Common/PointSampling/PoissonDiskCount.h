// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PointSampling/PoissonDisk.h"

namespace ink
{

/// A given number of blue-noise samples in progressive order (progressiveOrder): samplePoissonDisk with a
/// radius that gives a few too many, from which the most crowded ones are removed.
/// @param normals for the order: unit, one per point of the mesh; or empty, to use those of the triangles
/// @return `count` samples and the radius used; fewer if samples are so crowded that single precision cannot
///   tell them apart. Other parameters and errors as for samplePoissonDisk.
PoissonDisk samplePoissonDiskCount(const TriangleMesh& mesh, const CumulativeArea& areas,
  std::span<const glm::vec3> normals, std::size_t count, double slack, std::uint64_t seed,
  const Progress& progress = {});

/// Sorts samples by progressiveOrder, with radii that follow the mesh's density. Returns false, and leaves
/// them unsorted, when stopped.
bool sortByPriority(const TriangleMesh& mesh, const CumulativeArea& areas, std::span<const glm::vec3> normals,
  std::vector<SurfaceSample>& samples, std::uint64_t seed, const Progress& progress = {});

} // namespace ink
