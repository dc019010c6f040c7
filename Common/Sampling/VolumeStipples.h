#pragma once

#include "Fields/GridGeometry.h"
#include "Fields/SampleBox.h"
#include "Parallel/ParallelFor.h"
#include "Sampling/StippledVoxels.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace ink
{

struct VolumeStippleOptions
{
  /// N_max, at least 1: how many stipples each voxel gets.
  int perVoxel = 8;
  /// The distance of the planes p1 and p2 in sample steps, at least 0. From sqrt(3) on the whole voxel lies
  /// between them.
  double thickness = 1.0;
  std::uint64_t seed = 0;
};

/// How far, in samples, a voxel's stipples depend on which voxels are stippled, and on their gradients.
inline constexpr glm::ivec3 stippleReach{ 4, 2, 1 };

/// The most stipples that a voxel can have.
inline constexpr int maximumStipplesPerVoxel = 64;

/// Places stipples in voxels (Lu et al. 2003, section 4.2): each between two planes parallel to the tangent
/// plane through the voxel's sample, and inside the voxel.
///
/// A voxel's stipples are in order of priority: for every n, the first n of all voxels together are spread
/// evenly, approximately as a Poisson disc sampling. Evenly is meant as one sees it who looks along the
/// normal: distances are those between projections on the tangent plane, so that the layers of voxels that
/// make up a surface fill each other's gaps. They are relative to the voxel's size in world units.
///
/// Each stipple is the best of some candidates: the one whose nearest other stipple is farthest (Mitchell
/// 1991, section 4), measured by the spacing that stipples have when both are drawn. Voxels are filled in
/// eight classes by the parities of their global indices, each class minding its neighbors in the ones
/// before; in Gray code order, which keeps the chains of dependence short (stippleReach). So the stipples
/// depend on the seed, global indices and the surroundings only, not on threads or pieces.
///
/// \returns for each of the voxels perVoxel offsets from its sample, in sample steps, each in [-1/2, 1/2];
///          nothing when `progress` asked to stop
/// \throws std::invalid_argument when perVoxel or thickness is out of range
std::vector<glm::vec3> placeVolumeStipples(const GridGeometry& geometry, const StippledVoxels& voxels,
  const VolumeStippleOptions& options, const Progress& progress = {});

} // namespace ink
