// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/Derivatives/SeparableKernel.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace ink
{

namespace
{

/// With less than this fraction of the Gaussian's weight, a mean would consist of distant samples only.
constexpr double leastShare = 0.01;

/// Coefficients for the derivatives of the least-squares parabola a + b x + c x^2, or of the line.
void fitDerivatives(double deviation, std::span<const std::uint8_t> used, SeparableKernel& kernel)
{
  const int reach = static_cast<int>(used.size() / 2);
  // Use samples outside the Gaussian only if there are too few inside.
  const auto countWithin = [&](int limit)
  {
    int count = 0;
    for (int offset = -limit; offset <= limit; ++offset)
    {
      count += used[offset + reach] != 0;
    }
    return count;
  };
  const int within = std::max(1, static_cast<int>(std::ceil(4.0 * deviation)));
  const int limit = countWithin(within) >= 3 ? within : reach;
  const int count = countWithin(limit);
  const int terms = std::min(count, 3);
  if (terms < 2)
  {
    return;
  }
  // Three samples are fitted exactly with any weights, so equal ones suffice. With more, too uneven weights
  // would make the normal equations ill-conditioned.
  const double width = std::max(deviation, 0.5);
  const double unit = std::max(deviation, 1.0);
  const auto weightOf = [&](int offset)
  {
    return !used[offset + reach] ? 0.0
      : count <= 3               ? 1.0
                                 : std::exp(-offset * offset / (2.0 * width * width));
  };
  const auto powers = [&](int offset)
  {
    const double x = offset / unit;
    return Eigen::Vector3d(1.0, x, terms == 3 ? x * x : 0.0);
  };
  Eigen::Matrix3d moments = Eigen::Vector3d(0.0, 0.0, terms == 3 ? 0.0 : 1.0).asDiagonal();
  for (int offset = -limit; offset <= limit; ++offset)
  {
    moments += weightOf(offset) * powers(offset) * powers(offset).transpose();
  }
  const Eigen::Matrix3d inverse = moments.fullPivLu().inverse();
  for (int offset = -limit; offset <= limit; ++offset)
  {
    const Eigen::Vector3d coefficients = weightOf(offset) * (inverse * powers(offset));
    kernel.first[offset + reach] = coefficients[1] / unit;
    kernel.second[offset + reach] = 2.0 * coefficients[2] / (unit * unit);
  }
}

} // namespace

int separableReach(double deviation)
{
  return std::max(2, static_cast<int>(std::ceil(4.0 * deviation)));
}

SeparableKernel::SeparableKernel(double deviation, std::span<const std::uint8_t> used)
  : smooth(used.size(), 0.0)
  , first(used.size(), 0.0)
  , second(used.size(), 0.0)
{
  const int reach = static_cast<int>(used.size() / 2);
  // Narrower Gaussians are zero at all neighbors.
  const double width = std::max(deviation, 0.1);
  double whole = 0.0;
  double total = 0.0;
  for (int offset = -reach; offset <= reach; ++offset)
  {
    const double weight = std::exp(-offset * offset / (2.0 * width * width));
    whole += weight;
    if (used[offset + reach])
    {
      this->smooth[offset + reach] = weight;
      total += weight;
    }
  }
  this->exists = total >= leastShare * whole;
  for (double& coefficient : this->smooth)
  {
    coefficient = this->exists ? coefficient / total : 0.0;
  }
  if (this->exists)
  {
    fitDerivatives(deviation, used, *this);
  }
}

SeparableKernels::SeparableKernels(double deviation, int samples)
  : Deviation(deviation)
  , Reach(separableReach(deviation))
  , Samples(samples)
{
  const int reach = this->Reach;
  const int positions = std::min(samples, 2 * reach + 1);
  for (int position = 0; position < positions; ++position)
  {
    std::vector<std::uint8_t> used;
    for (int offset = -reach; offset <= reach; ++offset)
    {
      used.push_back(position + offset >= 0 && position + offset < positions);
    }
    this->Kernels.emplace_back(deviation, used);
  }
}

const SeparableKernel& SeparableKernels::operator[](int sample) const
{
  const int fromEnd = this->Samples - 1 - sample;
  const int position = this->Samples <= 2 * this->Reach + 1 || sample < this->Reach ? sample
    : fromEnd < this->Reach ? 2 * this->Reach - fromEnd
                            : this->Reach;
  return this->Kernels[position];
}

} // namespace ink
