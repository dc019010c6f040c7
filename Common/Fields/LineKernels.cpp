#include "Fields/LineKernels.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace ink
{

namespace
{

/// A mean of samples that have less than this share of the Gaussian would be one of far samples only.
constexpr double leastShare = 0.01;

/// Coefficients for the derivatives of the parabola a + b x + c x^2 that fits best, or of the straight line.
void fitDerivatives(double deviation, std::span<const std::uint8_t> used, LineKernel& kernel)
{
  const int reach = static_cast<int>(used.size() / 2);
  // Samples beyond the Gaussian only where there are too few within.
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
  // As three samples are fitted exactly with any weights, equal ones do where there are no more. The weights
  // of more must not be too uneven for the normal equations.
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

int lineReach(double deviation)
{
  return std::max(2, static_cast<int>(std::ceil(4.0 * deviation)));
}

LineKernel::LineKernel(double deviation, std::span<const std::uint8_t> used)
  : smooth(used.size(), 0.0)
  , first(used.size(), 0.0)
  , second(used.size(), 0.0)
{
  const int reach = static_cast<int>(used.size() / 2);
  // Narrower Gaussians than this are zero beyond the sample itself.
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

LineKernels::LineKernels(double deviation, int samples)
  : Deviation(deviation)
  , Reach(lineReach(deviation))
  , Samples(samples)
{
  const int reach = this->Reach;
  const int places = std::min(samples, 2 * reach + 1);
  for (int place = 0; place < places; ++place)
  {
    std::vector<std::uint8_t> used;
    for (int offset = -reach; offset <= reach; ++offset)
    {
      used.push_back(place + offset >= 0 && place + offset < places);
    }
    this->Kernels.emplace_back(deviation, used);
  }
}

const LineKernel& LineKernels::operator[](int sample) const
{
  const int fromEnd = this->Samples - 1 - sample;
  const int place = this->Samples <= 2 * this->Reach + 1 || sample < this->Reach ? sample
    : fromEnd < this->Reach                                                      ? 2 * this->Reach - fromEnd
                                                                                 : this->Reach;
  return this->Kernels[place];
}

} // namespace ink
