// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Fields/Derivatives/Gradients.h"
#include "Fields/SampleBox.h"
#include "Statistics/MagnitudeHistogram.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace ink
{
template <class T>
class GridField;
class PieceOwnership;
} // namespace ink

namespace ink::stipple
{

/// The statistics of a volume by which stippled voxels are chosen and values normalized (Lu et al. 2003,
/// sections 4.1 and 4.2).
struct VolumeStatistics
{
  /// Of the gradients' magnitudes, in value per world unit, at all samples that are not missing.
  MagnitudeHistogram magnitudes;
  /// Of the samples that are not missing; lowest > highest if all are.
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
};

/// Adds the owned samples of a grid to the statistics.
/// @return false when `progress` asked to stop
template <class T>
bool measureVolume(const GridField<T>& field, const PieceOwnership& own, const GradientOptions& gradient,
  VolumeStatistics& statistics, const Progress& progress = {});

/// Which voxels get stipples.
struct VoxelCriteria
{
  /// The minimum gradient magnitude, in value per world unit; a gradient of 0 never passes.
  float threshold = 0.0f;
  /// The voxel must contain a value in this range, according to its sample's value (smoothed if the gradient
  /// method smooths) and gradient. So the voxels of an iso-surface leave no holes where it passes from one
  /// layer to the next.
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
};

/// The voxels of a box to stipple, row by row. A voxel is the cube of one sample step around a sample.
struct StippledVoxels
{
  SampleBox box;
  /// Prefix sums: the number of voxels in all rows before row y + box.size().y * z, counted from the box's
  /// first row; one more entry for all rows.
  std::vector<std::size_t> rows;
  /// Per voxel: its sample's x in the grid, its gradient in value per world unit, and its value.
  std::vector<int> x;
  std::vector<glm::vec3> gradients;
  std::vector<float> values;

  std::size_t size() const { return this->x.size(); }
};

/// Finds the voxels of a box to stipple. Voxels of missing samples never are.
/// @return false when `progress` asked to stop
template <class T>
bool findStippledVoxels(const GridField<T>& field, const SampleBox& box, const GradientOptions& gradient,
  const VoxelCriteria& criteria, StippledVoxels& voxels, const Progress& progress = {});

} // namespace ink::stipple
