// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curvature/FieldCurvatureDerivative.h"
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
/// @param derivatives whether there are `derivatives`, by differences between points 1.5 of the smallest
///   spacing away: less shows that second derivatives are interpolated
/// @throws std::invalid_argument if the grid is smoothed and has fewer than 2 samples along an axis, or the
///   deviation is negative or not finite
template <class T>
MeshCurvature smoothedCurvatures(const GridField<T>& field, const glm::dvec3& deviation,
  std::span<const glm::dvec3> points, const Progress& progress = {}, bool derivatives = false)
{
  const GridGeometry& grid = field.geometry();
  const auto shareOf = [&progress](double begun, double share)
  {
    return progress
      ? Progress([&progress, begun, share](double done) { return progress(begun + share * done); })
      : progress;
  };
  const auto curvatures = [&](const FieldView& view, double begun)
  {
    const double share = (1.0 - begun) * (derivatives ? 0.2 : 1.0);
    MeshCurvature found = fieldCurvatures(view, points, shareOf(begun, share));
    if (derivatives)
    {
      constexpr double step = 1.5;
      const FieldDerivativeOptions options{ step * grid.smallestSpacing(),
        [&grid](const glm::dvec3& p) { return grid.contains(p); } };
      addFieldDerivatives(view, points, options, found, shareOf(begun + share, 1.0 - begun - share));
    }
    return found;
  };
  if (deviation == glm::dvec3(0.0))
  {
    return curvatures(FieldView(field), 0.0);
  }
  // Smoothing is about half of the work.
  using Work = SmoothedValue<T>;
  const std::vector<Work> values = smoothGrid(field, deviation, shareOf(0.0, 0.5));
  if (values.empty())
  {
    return {};
  }
  const GridField<Work> smooth(grid, std::span<const Work>(values));
  return curvatures(FieldView(smooth), 0.5);
}

} // namespace ink
