// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <vector>

namespace ink
{

template <class T>
class GridField;

/// The slices of a scan that are further apart than the samples within them.
struct ThickSlices
{
  int axis;         ///< across the slices
  glm::dvec2 sides; ///< of a sample along the other two axes, in multiples of the smallest spacing
  double distance;  ///< of slices, in the same unit
  double reach;     ///< how far distances are measured, in the same unit

  /// The slices' distance by the samples' along the longer axis within them.
  double ratio() const;
  /// The samples along each axis that a distance depends on.
  glm::ivec3 samples() const;

  static constexpr double leastRatio = 1.8;
  static constexpr double largestReach = 16.0; ///< but for twice the longer side
};

/// Slices that are leastRatio as far apart as samples are along either axis within them, if they are.
/// @param spacing of samples along each axis, not 0; signs do not matter
std::optional<ThickSlices> thickSlices(const glm::dvec3& spacing);

/// The samples of a grid as distances from the contour that an iso-value has in each slice, which are to be
/// interpolated in place of values: shape-based interpolation (Raya and Udupa, "Shape-based interpolation of
/// multidimensional objects", IEEE Transactions on Medical Imaging 9 (1), 1990), here of contours between
/// samples. Interpolated values make terraces of a surface that moves by more than the width of its edge from
/// one slice to the next.
///
/// Contours are the segments that marching squares finds, handed on from sample to sample, so that a few
/// distances are up to .05 too large. A distance depends on ThickSlices::samples() around it, bitwise.
///
/// @param ofMask contours are half way between the samples on both sides
/// @return in multiples of the smallest spacing, positive where samples are at or above the iso-value, up to
///   the reach on both sides, x fastest; NaN for missing samples, which no contour is next to. Empty when
///   `progress` asked to stop
template <class T>
std::vector<float> sliceDistances(const GridField<T>& field, double isoValue, bool ofMask,
  const ThickSlices& slices, const Progress& progress = {});

} // namespace ink
