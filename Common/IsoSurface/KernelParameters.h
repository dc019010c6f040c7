// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Grid/GridGeometry.h"
#include "IsoSurface/IsoThreshold.h"
#include "Simd/SamplingKernels.h"

#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace ink
{

/// Whether float is precise enough for every T and for sums and differences of a few.
template <class T>
inline constexpr bool FitsSingle = (std::is_integral_v<T> && sizeof(T) <= 2) || std::is_same_v<T, float>;

/// Classifies a grid's axes.
inline GridAxes axesOf(const GridGeometry& geometry)
{
  const auto isDiagonal = [](const glm::dmat3& m)
  {
    return m[0][1] == 0.0 && m[0][2] == 0.0 && m[1][0] == 0.0 && m[1][2] == 0.0 && m[2][0] == 0.0 &&
      m[2][1] == 0.0;
  };
  return geometry.gradientDirection() == glm::dmat3(1.0) && isDiagonal(geometry.stepToWorld())
    ? GridAxes::Cubic
    : isDiagonal(geometry.gradientDirection()) && isDiagonal(geometry.stepToWorld()) ? GridAxes::Aligned
                                                                                     : GridAxes::General;
}

/// The parameters that depend on the grid's geometry.
template <class Real>
KernelParameters<Real> kernelParameters(const GridGeometry& geometry)
{
  KernelParameters<Real> terms = {};
  const glm::dmat3& direction = geometry.gradientDirection();
  for (int column = 0; column < 3; ++column)
  {
    for (int row = 0; row < 3; ++row)
    {
      terms.step[column][row] = static_cast<Real>(geometry.stepToWorld()[column][row]);
      terms.direction[column][row] = static_cast<Real>(direction[column][row]);
    }
  }
  constexpr int pairs[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 1 }, { 0, 2 }, { 1, 2 } };
  for (int n = 0; n < 6; ++n)
  {
    const auto [a, b] = pairs[n];
    terms.square[n] = static_cast<Real>((a == b ? 1.0 : 2.0) * glm::dot(direction[a], direction[b]));
  }
  return terms;
}

/// The parameters for values of type T in single precision. Only for types that it represents exactly, and
/// for iso-values that some values reach.
template <class T>
KernelParameters<float> singleParameters(const GridGeometry& geometry, double isoValue)
{
  KernelParameters<float> terms = kernelParameters<float>(geometry);
  const double low = static_cast<double>(std::numeric_limits<T>::lowest());
  const double high = static_cast<double>(std::numeric_limits<T>::max());
  const double base = std::clamp(std::is_integral_v<T> ? std::floor(isoValue) : isoValue, low, high);
  terms.base = static_cast<float>(base);
  terms.rest = static_cast<float>(isoValue - static_cast<double>(terms.base));
  terms.atLeast = static_cast<float>(IsoThreshold<T>::atLeast(isoValue).lowest);
  const IsoThreshold<T> above = IsoThreshold<T>::above(isoValue);
  terms.above = above.reachable ? static_cast<float>(above.lowest) : std::numeric_limits<float>::infinity();
  terms.checkRange = std::is_floating_point_v<T>;
  return terms;
}

/// The parameters for values relative to the iso-value, in double.
inline KernelParameters<double> relativeParameters(const GridGeometry& geometry)
{
  KernelParameters<double> terms = kernelParameters<double>(geometry);
  terms.above = std::numeric_limits<double>::denorm_min();
  terms.checkRange = true;
  return terms;
}

} // namespace ink
