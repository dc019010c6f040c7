// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Fields/SampleBox.h"
#include "Stippling/StippledVoxels.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace ink
{
class GridGeometry;
} // namespace ink

namespace ink::stipple
{

struct VolumeStippleOptions
{
  /// N_max, the number of stipples per voxel, at least 1.
  int perVoxel = 8;
  /// The distance between the planes p1 and p2 in sample steps, at least 0. From sqrt(3) on the whole voxel
  /// lies between them.
  double thickness = 1.0;
  std::uint64_t seed = 0;
};

/// The neighborhood, in samples, of which voxels and gradients a voxel's stipples depend on.
inline constexpr glm::ivec3 stippleReach{ 4, 2, 1 };

/// The maximum number of stipples per voxel.
inline constexpr int maximumStipplesPerVoxel = 64;

/// Places stipples in voxels (Lu et al. 2003, section 4.2): each between two planes parallel to the tangent
/// plane through the voxel's sample, and inside the voxel.
///
/// A voxel's stipples are in order of priority: for every n, the first n of all voxels together are evenly
/// distributed, approximately as a Poisson-disk sampling. This holds as seen along the normal: distances are
/// between projections on the tangent plane, so that the layers of voxels that make up a surface fill each
/// other's voids. They are relative to the voxel's size in world units.
///
/// Each stipple is the best of some candidates: the one whose nearest other stipple is farthest (Mitchell
/// 1991, section 4), relative to the spacing that stipples have when both are drawn. Voxels are filled in
/// eight classes by the parities of their global indices, each taking the neighbors in earlier classes into
/// account; the classes are in Gray code order, which keeps chains of dependence short (stippleReach). So the
/// stipples depend only on the seed, global indices and the neighborhood, not on threads or pieces.
///
/// @return for each voxel perVoxel offsets from its sample, in sample steps, each in [-1/2, 1/2]; nothing
///   when `progress` asked to stop
/// @throws std::invalid_argument when perVoxel or thickness is out of range
std::vector<glm::vec3> placeVolumeStipples(const GridGeometry& geometry, const StippledVoxels& voxels,
  const VolumeStippleOptions& options, const Progress& progress = {});

} // namespace ink::stipple
