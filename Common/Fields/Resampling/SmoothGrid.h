// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Fields/Grid/GridField.h"

#include <glm/vec3.hpp>

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
  const GridField<T>& field, const glm::dvec3& deviation, const Progress& progress = {});

} // namespace ink
