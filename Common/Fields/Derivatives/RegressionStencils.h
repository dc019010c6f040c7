// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Derivatives/GradientRows.h"
#include "Fields/Derivatives/RegressionKernel.h"
#include "Fields/Grid/GridGeometry.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <cstdint>
#include <utility>
#include <vector>

namespace ink
{

/// The kernels of a regression for all positions of a sample relative to the grid's border: along each axis
/// the first `radius` samples, the last ones, and one position for all in between.
template <class Work>
class RegressionStencils
{
public:
  RegressionStencils(const GridGeometry& geometry, int radius, RegressionWeighting weighting)
    : Radius(radius)
    , Dimensions(geometry.dimensions())
    , Offsets(neighborhood(radius))
    , Weights(regressionWeights(geometry, radius, weighting))
  {
    this->Positions = glm::min(this->Dimensions, glm::ivec3(2 * this->Radius + 1));
    for (int c = 0; c < this->Positions.z; ++c)
    {
      for (int b = 0; b < this->Positions.y; ++b)
      {
        for (int a = 0; a < this->Positions.x; ++a)
        {
          this->Kernels.push_back(this->kernelAt({ a, b, c }));
          this->Taps.push_back(this->tapsOf(this->Kernels.back()));
        }
      }
    }
  }

  const std::vector<glm::ivec3>& offsets() const { return this->Offsets; }
  const std::vector<double>& weights() const { return this->Weights; }

  /// The kernel of a sample none of whose neighbors on the grid is missing.
  const RegressionKernel& operator[](const glm::ivec3& sample) const
  {
    return this->Kernels[this->index(sample)];
  }
  /// The same as taps for convolveRows(), only for offsets on the grid.
  const std::vector<RowTap<Work>>& taps(const glm::ivec3& sample) const
  {
    return this->Taps[this->index(sample)];
  }

private:
  std::size_t index(const glm::ivec3& sample) const
  {
    const glm::ivec3 p(this->positionOf(sample, 0), this->positionOf(sample, 1), this->positionOf(sample, 2));
    return p.x + static_cast<std::size_t>(this->Positions.x) * (p.y + this->Positions.y * p.z);
  }

  std::vector<RowTap<Work>> tapsOf(const RegressionKernel& kernel) const
  {
    std::vector<RowTap<Work>> taps;
    for (std::size_t n = 0; n < this->Offsets.size(); ++n)
    {
      if (kernel.gradient[n] != glm::dvec3(0.0) || kernel.value[n] != 0.0)
      {
        taps.push_back(
          { this->Offsets[n], glm::vec<3, Work>(kernel.gradient[n]), static_cast<Work>(kernel.value[n]) });
      }
    }
    return taps;
  }

  int positionOf(const glm::ivec3& sample, int axis) const
  {
    const int n = this->Dimensions[axis];
    const int fromEnd = n - 1 - sample[axis];
    return this->Positions[axis] == n || sample[axis] < this->Radius ? sample[axis]
      : fromEnd < this->Radius                                       ? 2 * this->Radius - fromEnd
                                                                     : this->Radius;
  }

  RegressionKernel kernelAt(const glm::ivec3& position) const
  {
    std::vector<std::uint8_t> used;
    for (const glm::ivec3& offset : this->Offsets)
    {
      const glm::ivec3 neighbor = position + offset;
      used.push_back(glm::all(glm::greaterThanEqual(neighbor, glm::ivec3(0))) &&
        glm::all(glm::lessThan(neighbor, this->Positions)));
    }
    return RegressionKernel(this->Offsets, this->Weights, used);
  }

  int Radius;
  glm::ivec3 Dimensions;
  glm::ivec3 Positions;
  std::vector<glm::ivec3> Offsets;
  std::vector<double> Weights;
  std::vector<RegressionKernel> Kernels;
  std::vector<std::vector<RowTap<Work>>> Taps;
};

} // namespace ink
