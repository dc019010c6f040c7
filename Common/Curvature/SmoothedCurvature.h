// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curvature/FieldCurvature.h"
#include "Fields/FieldView.h"
#include "Fields/Grid/GridField.h"
#include "Fields/Resampling/SmoothGrid.h"

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace ink
{

/// fieldCurvatures of a grid's values, smoothed by a Gaussian: second derivatives say more of noise than of
/// form where noise is not removed. Missing samples do not count (see TileResampler).
/// @param deviation of the Gaussian along each axis, in samples; all 0: the values as they are
/// @param progress when it asks to stop, the result is empty
/// @throws std::invalid_argument if the grid is smoothed and has fewer than 2 samples along an axis, or the
///   deviation is negative or not finite
template <class T>
MeshCurvature smoothedCurvatures(const GridField<T>& field, const glm::dvec3& deviation,
  std::span<const glm::dvec3> points, const Progress& progress = {})
{
  if (deviation == glm::dvec3(0.0))
  {
    return fieldCurvatures(FieldView(field), points, progress);
  }
  // About half of the work.
  const auto half = [&](double begun)
  {
    return progress ? Progress([&progress, begun](double done) { return progress(begun + 0.5 * done); })
                    : progress;
  };
  using Work = SmoothedValue<T>;
  const std::vector<Work> values = smoothGrid(field, deviation, half(0.0));
  if (values.empty())
  {
    return {};
  }
  const GridField<Work> smooth(field.geometry(), std::span<const Work>(values));
  return fieldCurvatures(FieldView(smooth), points, half(0.5));
}

} // namespace ink
