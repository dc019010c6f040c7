// SPDX-License-Identifier: BSD-3-Clause
#include "Stippling/StippledVoxels.h"

#include "Core/ParallelFor.h"
#include "Fields/Grid/GridField.h"
#include "Fields/Grid/PieceOwnership.h"
#include "Fields/ScalarDifference.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>
#include <span>
#include <type_traits>

namespace ink::stipple
{
namespace
{

/// The number of samples whose gradients are computed at a time, so that they stay in the cache until they
/// are used.
constexpr std::size_t slabSize = std::size_t(1) << 20;

/// The box's layers, divided into slabs of at most slabSize samples, at least one layer.
std::vector<SampleBox> slabsOf(const SampleBox& box)
{
  std::vector<SampleBox> slabs;
  if (!box.empty())
  {
    const std::size_t layer = static_cast<std::size_t>(box.size().x) * box.size().y;
    const int thickness = static_cast<int>(std::clamp<std::size_t>(slabSize / layer, 1, box.size().z));
    for (int z = box.begin.z; z < box.end.z; z += thickness)
    {
      slabs.push_back(box);
      slabs.back().begin.z = z;
      slabs.back().end.z = std::min(z + thickness, box.end.z);
    }
  }
  return slabs;
}

/// Adds the owned samples of a row from `first` on, and their gradient magnitudes.
template <class T>
void addRow(const GridField<T>& field, const PieceOwnership& own, const glm::ivec3& first,
  std::span<const float> magnitudes, VolumeStatistics& statistics)
{
  const bool complete = std::is_integral_v<T> && field.hidden().empty() && own.wholeBox();
  if (complete)
  {
    statistics.magnitudes.add(magnitudes);
  }
  T lowest = std::numeric_limits<T>::max();
  T highest = std::numeric_limits<T>::lowest();
  for (std::size_t x = 0; x < magnitudes.size(); ++x)
  {
    const glm::ivec3 sample = first + glm::ivec3(x, 0, 0);
    if (complete || (field.has(sample) && own.has(sample)))
    {
      const T value = field.at(sample);
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
      if (!complete)
      {
        statistics.magnitudes.add(magnitudes.subspan(x, 1));
      }
    }
  }
  if (lowest <= highest)
  {
    statistics.lowest = std::min(statistics.lowest, static_cast<double>(lowest));
    statistics.highest = std::max(statistics.highest, static_cast<double>(highest));
  }
}

} // namespace

template <class T>
bool measureVolume(const GridField<T>& field, const PieceOwnership& own, const GradientOptions& gradient,
  VolumeStatistics& statistics, const Progress& progress)
{
  const std::vector<SampleBox> slabs = slabsOf(own.box());
  std::vector<float> magnitudes;
  std::mutex merging;
  for (std::size_t s = 0; s < slabs.size(); ++s)
  {
    const SampleBox& slab = slabs[s];
    magnitudes.resize(slab.count());
    estimateGradients<T, float>(field, slab, gradient, { {}, magnitudes, {} });
    // A histogram is large: a few of them are enough.
    constexpr std::size_t parts = 8;
    const std::size_t width = static_cast<std::size_t>(slab.size().x);
    const std::size_t rows = slab.count() / width;
    parallelFor(parts,
      [&](std::size_t p)
      {
        VolumeStatistics part;
        for (std::size_t row = p * rows / parts; row < (p + 1) * rows / parts; ++row)
        {
          const int layerRows = slab.size().y;
          const glm::ivec3 first =
            slab.begin + glm::ivec3(0, static_cast<int>(row) % layerRows, static_cast<int>(row) / layerRows);
          addRow(field, own, first, std::span<const float>(magnitudes).subspan(row * width, width), part);
        }
        const std::lock_guard lock(merging);
        statistics.magnitudes.add(part.magnitudes);
        statistics.lowest = std::min(statistics.lowest, part.lowest);
        statistics.highest = std::max(statistics.highest, part.highest);
      });
    if (progress && !progress(static_cast<double>(s + 1) / static_cast<double>(slabs.size())))
    {
      return false;
    }
  }
  return true;
}

template <class T>
bool findStippledVoxels(const GridField<T>& field, const SampleBox& box, const GradientOptions& gradient,
  const VoxelCriteria& criteria, StippledVoxels& voxels, const Progress& progress)
{
  voxels = {};
  voxels.box = box;
  const glm::ivec3 size = glm::max(box.size(), glm::ivec3(0));
  voxels.rows.assign(static_cast<std::size_t>(size.y) * size.z + 1, 0);
  const std::vector<SampleBox> slabs = slabsOf(box);
  const bool windowed = std::isfinite(criteria.lowest) || std::isfinite(criteria.highest);
  // Its columns are the vectors from a voxel's sample to its face centers.
  const GridGeometry& geometry = field.geometry();
  const glm::dvec3 halves = 0.5 * geometry.spacing();
  const glm::mat3 halfSteps(geometry.direction()[0] * halves.x, geometry.direction()[1] * halves.y,
    geometry.direction()[2] * halves.z);
  std::vector<float> gradients;
  std::vector<float> magnitudes;
  std::vector<float> values;
  std::size_t* before = voxels.rows.data();
  for (std::size_t s = 0; s < slabs.size(); ++s)
  {
    const std::size_t count = slabs[s].count();
    gradients.resize(3 * count);
    magnitudes.resize(count);
    values.resize(count);
    estimateGradients<T, float>(field, slabs[s], gradient, { gradients, magnitudes, values });
    const auto isInWindow = [&](std::size_t n)
    {
      const glm::vec3 slope(gradients[3 * n], gradients[3 * n + 1], gradients[3 * n + 2]);
      const glm::vec3 reach = glm::abs(slope * halfSteps);
      const float most = reach.x + reach.y + reach.z;
      return criteria.lowest <= criteria.highest && values[n] + most >= criteria.lowest &&
        values[n] - most <= criteria.highest;
    };
    const auto chosen = [&](std::size_t n)
    { return magnitudes[n] > 0.0f && magnitudes[n] >= criteria.threshold && (!windowed || isInWindow(n)); };
    const std::size_t width = static_cast<std::size_t>(size.x);
    const std::size_t rows = count / width;
    parallelFor(rows,
      [&](std::size_t row)
      {
        std::size_t number = 0;
        for (std::size_t n = row * width; n < (row + 1) * width; ++n)
        {
          number += chosen(n);
        }
        before[row + 1] = number;
      });
    std::partial_sum(before, before + rows + 1, before);
    voxels.x.resize(before[rows]);
    voxels.gradients.resize(before[rows]);
    voxels.values.resize(before[rows]);
    parallelFor(rows,
      [&](std::size_t row)
      {
        std::size_t to = before[row];
        for (std::size_t n = row * width; n < (row + 1) * width; ++n)
        {
          if (chosen(n))
          {
            voxels.x[to] = box.begin.x + static_cast<int>(n - row * width);
            voxels.gradients[to] = { gradients[3 * n], gradients[3 * n + 1], gradients[3 * n + 2] };
            voxels.values[to] = values[n];
            ++to;
          }
        }
      });
    before += rows;
    if (progress && !progress(static_cast<double>(s + 1) / static_cast<double>(slabs.size())))
    {
      return false;
    }
  }
  return true;
}

#define INK_INSTANTIATE(T)                                                                                   \
  template bool measureVolume(                                                                               \
    const GridField<T>&, const PieceOwnership&, const GradientOptions&, VolumeStatistics&, const Progress&); \
  template bool findStippledVoxels(const GridField<T>&, const SampleBox&, const GradientOptions&,            \
    const VoxelCriteria&, StippledVoxels&, const Progress&);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink::stipple
