// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Resampling/ResampleGrid.h"

#include <glm/vec3.hpp>

#include <span>
#include <type_traits>
#include <vector>

namespace ink
{

/// What values are smoothed in: numbers that float holds, as floats.
template <class T>
using SmoothedValue = std::conditional_t<std::is_same_v<T, float> || sizeof(T) <= 2, float, double>;

/// A grid's values, x fastest, smoothed by a Gaussian: at its own samples, see resampleGrid.
/// @param deviation along each axis, in samples
/// @param progress when it asks to stop, the result is empty
/// @throws std::invalid_argument if the grid has fewer than 2 samples along an axis, or the deviation is
///   negative or not finite
template <class T>
std::vector<SmoothedValue<T>> smoothGrid(
  const GridField<T>& field, const glm::dvec3& deviation, const Progress& progress = {})
{
  const GridGeometry& geometry = field.geometry();
  const auto along = [&](int axis)
  { return AxisResampling(deviation[axis], 1, geometry.dimensions()[axis]); };
  std::vector<SmoothedValue<T>> values(geometry.sampleCount());
  const bool finished =
    resampleGrid(field, { along(0), along(1), along(2) }, std::span<SmoothedValue<T>>(values), progress);
  return finished ? values : std::vector<SmoothedValue<T>>();
}

} // namespace ink
