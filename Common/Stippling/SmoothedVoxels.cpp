// SPDX-License-Identifier: BSD-3-Clause
#include "Stippling/SmoothedVoxels.h"

#include "Fields/Grid/GridField.h"
#include "Fields/Grid/PieceOwnership.h"
#include "Fields/Resampling/ResampleGrid.h"
#include "Fields/Resampling/SmoothGrid.h"

#include <glm/common.hpp>

#include <algorithm>
#include <limits>
#include <type_traits>

namespace ink::stipple
{
namespace
{

/// Slices that are smoothed at a time.
constexpr int slabThickness = 32;

GridResampling smoothingOf(const glm::dvec3& deviation, const glm::ivec3& samples)
{
  const auto along = [&](int axis)
  { return AxisResampling(samples[axis] > 1 ? deviation[axis] : 0.0, 1, std::max(samples[axis], 2)); };
  return { along(0), along(1), along(2) };
}

/// Calls use(field, box, first, progress) for some slices of a box after the other: with the smoothed field
/// around them, the part of the box in samples of that field, and the sample at which the field begins.
/// @return false when one of them does
template <class T, class Use>
bool forEachSmoothedSlab(const GridField<T>& field, const glm::dvec3& deviation, const SampleBox& box,
  int margin, const Progress& progress, const Use& use)
{
  using Work = SmoothedValue<T>;
  const GridGeometry& geometry = field.geometry();
  const glm::ivec3& samples = geometry.dimensions();
  const GridResampling smoothing = smoothingOf(deviation, samples);
  const bool mayLack = !field.hidden().empty() || std::is_floating_point_v<T>;
  std::vector<Work> values;
  for (int z = box.begin.z; z < box.end.z; z += slabThickness)
  {
    SampleBox slab = box;
    slab.begin.z = z;
    slab.end.z = std::min(z + slabThickness, box.end.z);
    const SampleBox around = { glm::max(slab.begin - margin, glm::ivec3(0)),
      glm::min(slab.end + margin, samples) };
    values.resize(around.count());
    resampleGrid(field, smoothing, around, std::span<Work>(values));
    const GridField<Work> smoothed(GridGeometry(around.size(), geometry.origin(), geometry.spacing(),
                                     geometry.direction(), geometry.first() + around.begin),
      values);
    for (glm::ivec3 s = around.begin; mayLack && s.z < around.end.z; ++s.z)
    {
      for (s.y = around.begin.y; s.y < around.end.y; ++s.y)
      {
        for (s.x = around.begin.x; s.x < around.end.x; ++s.x)
        {
          if (!field.has(s))
          {
            values[smoothed.geometry().offset(s - around.begin)] = std::numeric_limits<Work>::quiet_NaN();
          }
        }
      }
    }
    const double whole = box.end.z - box.begin.z;
    const auto inSlab = [&](double done)
    { return !progress || progress((z - box.begin.z + done * (slab.end.z - z)) / whole); };
    if (!use(smoothed, SampleBox{ slab.begin - around.begin, slab.end - around.begin }, around.begin, inSlab))
    {
      return false;
    }
  }
  return true;
}

} // namespace

int smoothingReach(double deviation)
{
  return deviation > 0.0 ? AxisResampling(deviation, 1, 2).reach() : 0;
}

template <class T>
bool measureVolume(const GridField<T>& field, const glm::dvec3& deviation, const PieceOwnership& own,
  const GradientOptions& gradient, VolumeStatistics& statistics, const Progress& progress)
{
  if (deviation == glm::dvec3(0.0))
  {
    return measureVolume(field, own, gradient, statistics, progress);
  }
  return own.box().empty() ||
    forEachSmoothedSlab(field, deviation, own.box(), gradientReach(gradient), progress,
      [&](const auto& smoothed, const SampleBox& box, const glm::ivec3& first, const Progress& inSlab)
      { return measureVolume(smoothed, own.ofPart(first, box), gradient, statistics, inSlab); });
}

template <class T>
bool findStippledVoxels(const GridField<T>& field, const glm::dvec3& deviation, const SampleBox& box,
  const GradientOptions& gradient, const VoxelCriteria& criteria, StippledVoxels& voxels,
  const Progress& progress)
{
  if (deviation == glm::dvec3(0.0) || box.empty())
  {
    return findStippledVoxels(field, box, gradient, criteria, voxels, progress);
  }
  voxels = {};
  voxels.box = box;
  voxels.rows.assign(1, 0);
  const auto find =
    [&](const auto& smoothed, const SampleBox& slab, const glm::ivec3& first, const Progress& inSlab)
  {
    StippledVoxels part;
    if (!findStippledVoxels(smoothed, slab, gradient, criteria, part, inSlab))
    {
      return false;
    }
    const std::size_t before = voxels.size();
    std::transform(part.rows.begin() + 1, part.rows.end(), std::back_inserter(voxels.rows),
      [before](std::size_t row) { return before + row; });
    std::transform(
      part.x.begin(), part.x.end(), std::back_inserter(voxels.x), [&first](int x) { return x + first.x; });
    voxels.gradients.insert(voxels.gradients.end(), part.gradients.begin(), part.gradients.end());
    voxels.values.insert(voxels.values.end(), part.values.begin(), part.values.end());
    return true;
  };
  return forEachSmoothedSlab(field, deviation, box, gradientReach(gradient), progress, find);
}

#define INK_INSTANTIATE(T)                                                                                   \
  template bool measureVolume(const GridField<T>&, const glm::dvec3&, const PieceOwnership&,                 \
    const GradientOptions&, VolumeStatistics&, const Progress&);                                             \
  template bool findStippledVoxels(const GridField<T>&, const glm::dvec3&, const SampleBox&,                 \
    const GradientOptions&, const VoxelCriteria&, StippledVoxels&, const Progress&);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink::stipple
