// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Fields/SampleBox.h"

#include <glm/vec3.hpp>

#include <span>

namespace ink
{

template <class T>
class GridField;
class GridGeometry;

/// The unit of a Gaussian's scale, its standard deviation.
enum class ScaleUnit
{
  /// Samples: the same number along each axis, whatever the spacing.
  Samples,
  /// World units: the same distance along each axis.
  World
};

/// Scales are clamped to this, in samples.
inline constexpr double largestGaussian = 16.0;

/// The standard deviation of a Gaussian along each axis, in samples, from 0 to largestGaussian.
glm::dvec3 gaussianInSamples(const GridGeometry& geometry, double scale, ScaleUnit unit);

/// The radius of a Laplacian's support along each axis, in samples: four standard deviations, at least 1.
glm::ivec3 laplacianReach(const glm::dvec3& deviation);

/// The Laplacian of Gaussian (LoG) at the samples of a box, in value per world unit squared, also using
/// samples of the grid around it. A deviation of 0 does not smooth: the result is the sum of second
/// differences.
///
/// It is separable. Along each axis the smoothed value is the mean weighted by the Gaussian, and the
/// derivatives are those of the parabola fitted by least squares with these weights. Inside a grid that is
/// the sampled Gaussian and its derivatives, scaled to be exact for quadratics; at the grid's border and next
/// to missing samples (hidden, NaN or infinite) means and parabolas use the samples that exist, and along an
/// axis with fewer than three samples the second derivative is 0. At a missing sample the result is 0. Where
/// the axes are not orthogonal, mixed derivatives contribute as well.
///
/// 64-bit integers are rounded to double: beyond 2^53 the error of a value v is up to v / 2^53, and that of
/// an unsmoothed Laplacian up to 12 times as large for a spacing of 1. (Taking differences from one of the
/// grid's values would be more accurate, but parts of a grid would not be bitwise equal to the whole.)
///
/// @param deviation standard deviation along each axis, in samples
/// @param laplacian one value per sample of the box, x fastest; clamped to the range of Real
/// @return false when `progress` asked to stop
/// @throws std::invalid_argument when the box exceeds the grid, the array does not have its size, or a
///   deviation is negative, above largestGaussian or NaN
template <class T, class Real>
bool laplacianOfGaussian(const GridField<T>& field, const SampleBox& box, const glm::dvec3& deviation,
  std::span<Real> laplacian, const Progress& progress = {});

} // namespace ink
