// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Derivatives/LaplacianFactors.h"
#include "Fields/Derivatives/LaplacianRows.h"
#include "Fields/Derivatives/SeparableKernel.h"
#include "Fields/Grid/GridField.h"

#include <glm/vec3.hpp>

#include <type_traits>

/// Internal to Common/Fields: the filters of ink::laplacianOfGaussian.
namespace ink
{

/// One side of a kernel without missing samples, its second derivative scaled by its factor in the Laplacian.
struct MirroredLine
{
  HalfKernel smooth;
  HalfKernel first;
  HalfKernel second;
};

/// The filter along an axis.
struct LinePlan
{
  SeparableKernels kernels;
  int dimension;
  MirroredLine inside;

  /// @param factor of the second derivative
  LinePlan(double deviation, int samples, double factor)
    : kernels(deviation, samples)
    , dimension(samples)
  {
    const int reach = this->kernels.reach();
    if (samples > 2 * reach)
    {
      const SeparableKernel& kernel = this->kernels[reach];
      for (int n = reach + 1; n <= 2 * reach; ++n)
      {
        this->inside.smooth.push_back(kernel.smooth[n]);
        this->inside.first.push_back(kernel.first[n]);
        this->inside.second.push_back(factor * kernel.second[n]);
      }
      // A Gaussian may be narrower than its kernel.
      while (!this->inside.smooth.empty() && this->inside.smooth.back() == 0.0 &&
        this->inside.first.back() == 0.0 && this->inside.second.back() == 0.0)
      {
        this->inside.smooth.pop_back();
        this->inside.first.pop_back();
        this->inside.second.pop_back();
      }
    }
  }

  /// Whether the whole kernel lies on the grid.
  bool isInside(int sample) const
  {
    return sample >= this->kernels.reach() && sample < this->dimension - this->kernels.reach();
  }
};

/// What all tiles have in common.
template <class T>
struct LaplacianPlan
{
  const GridField<T>& field;
  glm::ivec3 dimensions;
  glm::ivec3 reach;
  LaplacianFactors factors;
  LinePlan x;
  LinePlan y;
  LinePlan z;
  /// Whether the axes are not orthogonal.
  bool mixed;

  LaplacianPlan(const GridField<T>& grid, const glm::dvec3& deviation)
    : field(grid)
    , dimensions(grid.geometry().dimensions())
    , reach(separableReach(deviation.x), separableReach(deviation.y), separableReach(deviation.z))
    , factors(grid.geometry())
    , x(deviation.x, dimensions.x, factors.straight.x)
    , y(deviation.y, dimensions.y, factors.straight.y)
    , z(deviation.z, dimensions.z, factors.straight.z)
    , mixed(factors.xy != 0.0 || factors.xz != 0.0 || factors.yz != 0.0)
  {
  }
};

/// The scale of intermediate results, so that sums of the largest doubles do not overflow.
template <class T>
inline constexpr double laplacianScale = std::is_same_v<T, double> ? 0x1p-60 : 1.0;

} // namespace ink
