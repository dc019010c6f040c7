#pragma once

#include "Fields/GridField.h"
#include "Fields/RegressionKernel.h"
#include "Fields/SampleBox.h"
#include "Parallel/ParallelFor.h"

#include <span>

namespace ink
{

/// How a grid's samples become gradients.
enum class GradientMethod
{
  /// Half the difference of the two neighbors along each axis: exact for quadratics inside the grid.
  CentralDifference,
  /// The plane that fits a sample and its neighbors best: 4D linear regression, Neumann et al. (2000), as
  /// Lu et al. (2003), section 4.1, use it. Exact for planes; inside the grid the gradient is exact for
  /// quadratics, too. Noise is averaged away.
  Regression
};

struct GradientOptions
{
  GradientMethod method = GradientMethod::Regression;
  /// Of a regression's neighborhood, in samples: 1 for 3 x 3 x 3, 2 for 5 x 5 x 5.
  int radius = 1;
  RegressionWeighting weighting = RegressionWeighting::Uniform;
};

/// How many samples beyond a sample its gradient depends on, along each axis.
int gradientReach(const GradientOptions& options);

/// Where the results go, those of a box's samples with x running fastest. What is empty is not computed.
template <class Real>
struct GradientArrays
{
  /// Three values for each sample: first derivatives in value per world unit.
  std::span<Real> gradient;
  /// Its length.
  std::span<Real> magnitude;
  /// The regression's value at the sample, a smoothed one; for central differences the sample's own.
  std::span<Real> value;
};

/// Estimates the gradients of the samples in a box; samples of the grid around it are used, too.
///
/// Beside the grid's border, and beside missing samples (hidden, NaN or infinite), differences are one-sided
/// and a regression fits the neighbors that there are; along a direction in which there are none the
/// derivative is 0. At a missing sample everything is 0. Results that are too large for Real become its
/// largest value.
///
/// Sums are taken in single precision where the grid holds floats or integers of at most 16 bits and Real is
/// float, otherwise in double. Any two boxes of a grid, and any number of threads, give the same bits.
///
/// \returns false when `progress` asked to stop
/// \throws std::invalid_argument when the box leaves the grid, an array has not the box's size, or the
///         radius is neither 1 nor 2
template <class T, class Real>
bool estimateGradients(const GridField<T>& field, const SampleBox& box, const GradientOptions& options,
  const GradientArrays<Real>& arrays, const Progress& progress = {});

} // namespace ink
