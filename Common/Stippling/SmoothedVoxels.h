// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Stippling/StippledVoxels.h"

namespace ink::stipple
{

/// Samples around one that its smoothed value depends on, along any axis, for a Gaussian of that standard
/// deviation in samples; 0 for 0.
int smoothingReach(double deviation);

/// measureVolume of a grid's values after a Gaussian, some slices at a time, so that there never is a
/// smoothed copy of the grid. Missing samples do not count and stay missing (see TileResampler). Parts of a
/// grid agree bitwise where they have smoothingReach() more samples than measureVolume needs.
/// @param deviation of the Gaussian along each axis, in samples, see smoothingDeviation; 0: the values as
/// they
///   are. Axes of one sample are not smoothed
template <class T>
bool measureVolume(const GridField<T>& field, const glm::dvec3& deviation, const PieceOwnership& own,
  const GradientOptions& gradient, VolumeStatistics& statistics, const Progress& progress = {});

/// The same of findStippledVoxels.
template <class T>
bool findStippledVoxels(const GridField<T>& field, const glm::dvec3& deviation, const SampleBox& box,
  const GradientOptions& gradient, const VoxelCriteria& criteria, StippledVoxels& voxels,
  const Progress& progress = {});

} // namespace ink::stipple
