#pragma once

#include "Fields/GridField.h"
#include "Fields/SampleBox.h"
#include "Parallel/ParallelFor.h"

#include <glm/vec3.hpp>

#include <span>

namespace ink
{

/// What a Gaussian's scale, its standard deviation, is measured in.
enum class ScaleUnit
{
  /// Samples: as many along each axis, whatever the spacing.
  Samples,
  /// World units: as far along each axis.
  World
};

/// Scales beyond this, in samples, count as this.
inline constexpr double largestGaussian = 16.0;

/// The deviation of a Gaussian along each axis, in samples, from 0 to largestGaussian.
glm::dvec3 gaussianInSamples(const GridGeometry& geometry, double scale, ScaleUnit unit);

/// How many samples beyond a sample its Laplacian depends on, along each axis: four deviations, at least 1.
glm::ivec3 laplacianReach(const glm::dvec3& deviation);

/// The Laplacian of a grid smoothed by a Gaussian, in value per world unit squared, of the samples in a box.
/// Samples of the grid around it are used, too. A deviation of 0 does not smooth: then it is the sum of
/// second differences.
///
/// It is computed axis by axis. Along each the smoothed value is a weighted mean, with the Gaussian as the
/// weight, and the derivatives are those of the parabola that fits best with these weights. Inside a grid
/// that is the sampled Gaussian and its derivatives, scaled so that they are exact for quadratics; beside the
/// grid's border and beside missing samples (hidden, NaN or infinite) means and parabolas are those of the
/// samples that there are, and along an axis with fewer than three samples there is no second derivative. At
/// a missing sample the result is 0. Where the axes are not at right angles the mixed derivatives have their
/// part, too.
///
/// 64-bit integers count as the nearest doubles: beyond 2^53 one of magnitude v is off by up to v / 2^53, and
/// a Laplacian that is not smoothed by up to 12 times that where the spacing is 1. (Relative to one of the
/// grid's values more of them would be exact, but parts of a grid would not give the bits of the whole.)
///
/// \param deviation along each axis, in samples
/// \param laplacian one value for each sample of the box with x running fastest; no larger than Real can hold
/// \returns false when `progress` asked to stop
/// \throws std::invalid_argument when the box leaves the grid, the array has not its size, or a deviation is
///         negative, above largestGaussian or NaN
template <class T, class Real>
bool laplacianOfGaussian(const GridField<T>& field, const SampleBox& box, const glm::dvec3& deviation,
  std::span<Real> laplacian, const Progress& progress = {});

} // namespace ink
