// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Fields/Derivatives/RegressionKernel.h"
#include "Fields/SampleBox.h"

#include <span>

namespace ink
{

template <class T>
class GridField;

/// How gradients are estimated from a grid's samples.
enum class GradientMethod
{
  /// Half the difference of the two neighbors along each axis: exact for quadratics inside the grid.
  CentralDifference,
  /// The hyperplane fitted by least squares to a sample and its neighbors: 4D linear regression (Neumann et
  /// al. 2000), as used by Lu et al. (2003, section 4.1). Exact for linear functions; inside the grid the
  /// gradient is also exact for quadratics. Averages out noise.
  Regression
};

struct GradientOptions
{
  GradientMethod method = GradientMethod::Regression;
  /// The radius of a regression's neighborhood in samples: 1 for 3 x 3 x 3, 2 for 5 x 5 x 5.
  int radius = 1;
  RegressionWeighting weighting = RegressionWeighting::Uniform;
};

/// The radius of a gradient's support: the number of samples on either side along each axis that it depends
/// on.
int gradientReach(const GradientOptions& options);

/// Output arrays for the samples of a box, x fastest. Empty ones are not computed.
template <class Real>
struct GradientArrays
{
  /// Three values per sample: first derivatives in value per world unit.
  std::span<Real> gradient;
  /// The gradient magnitude.
  std::span<Real> magnitude;
  /// The regression's smoothed value at the sample; for central differences the sample itself.
  std::span<Real> value;
};

/// Estimates the gradients at the samples of a box, also using samples of the grid around it.
///
/// At the grid's border, and next to missing samples (hidden, NaN or infinite), differences are one-sided and
/// a regression uses the neighbors that exist; along a direction without neighbors the derivative is 0. At a
/// missing sample all results are 0. Results too large for Real are clamped to its largest value.
///
/// Sums are taken in single precision where the grid holds floats or integers of at most 16 bits and Real is
/// float, otherwise in double. Results are bitwise independent of the box and the number of threads.
///
/// @return false when `progress` asked to stop
/// @throws std::invalid_argument when the box exceeds the grid, an array does not have the box's size, or the
///   radius is neither 1 nor 2
template <class T, class Real>
bool estimateGradients(const GridField<T>& field, const SampleBox& box, const GradientOptions& options,
  const GradientArrays<Real>& arrays, const Progress& progress = {});

} // namespace ink
