#pragma once

#include "Fields/Gradients.h"
#include "Fields/GridField.h"
#include "Fields/OwnSamples.h"
#include "Parallel/ParallelFor.h"
#include "Statistics/MagnitudeHistogram.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace ink
{

/// What a volume's stipples are chosen and normalized by (Lu et al. 2003, sections 4.1 and 4.2).
struct VolumeStatistics
{
  /// The lengths of the world gradients at all samples that are not missing.
  MagnitudeHistogram magnitudes;
  /// Of the samples that are not missing; lowest > highest without any.
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
};

/// Adds one's own samples of a grid to the statistics.
/// \returns false when `progress` asked to stop
template <class T>
bool measureVolume(const GridField<T>& field, const OwnSamples& own, const GradientOptions& gradient,
  VolumeStatistics& statistics, const Progress& progress = {});

/// Which voxels get stipples.
struct VoxelCriteria
{
  /// A voxel's gradient must be at least this long, in value per world unit, and longer than 0.
  float threshold = 0.0f;
  /// Somewhere in it must be a value between these, by its sample's value, smoothed where the gradient's
  /// method smooths, and gradient: so an iso-surface's voxels have no gaps where it passes from one layer to
  /// the next.
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
};

/// The voxels of a box that are to be stippled, row by row. A voxel is the cube of one sample step around a
/// sample.
struct StippledVoxels
{
  SampleBox box;
  /// How many voxels the rows before row y + box.size().y * z, counted from the box's first, hold; one more
  /// at the end.
  std::vector<std::size_t> rows;
  /// For each voxel its sample's x in the grid, its gradient in value per world unit, and its value.
  std::vector<int> x;
  std::vector<glm::vec3> gradients;
  std::vector<float> values;

  std::size_t size() const { return this->x.size(); }
};

/// Finds the voxels of a box by their gradients. A missing sample's voxel is never one.
/// \returns false when `progress` asked to stop
template <class T>
bool findStippledVoxels(const GridField<T>& field, const SampleBox& box, const GradientOptions& gradient,
  const VoxelCriteria& criteria, StippledVoxels& voxels, const Progress& progress = {});

} // namespace ink
