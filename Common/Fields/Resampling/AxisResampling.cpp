// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/Resampling/AxisResampling.h"

#include "Fields/Grid/GridGeometry.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace ink
{
namespace
{

/// The share of a position's weights that may be left out at the rim of the Gaussian.
constexpr double negligible = 5e-4;

/// Nodes of the quadrature over the Gaussian on each side of its center, and how far they go, in deviations.
constexpr int nodes = 32;
constexpr double nodesEnd = 4.0;

constexpr double largestDeviation = 100.0;

struct Kernel
{
  SmoothingKernel form;
  double deviation;

  /// @param z the distance in deviations
  double operator()(double z) const
  {
    const double gaussian = std::exp(-0.5 * z * z);
    return this->form == SmoothingKernel::FourthOrder ? 0.5 * (3.0 - z * z) * gaussian : gaussian;
  }
};

/// The first and the last sample of an axis.
struct AxisEnds
{
  int low = std::numeric_limits<int>::min() / 2;
  int high = std::numeric_limits<int>::max() / 2;
};

/// Adds the weights that the interpolant has at x; the first weight belongs to sample `first`.
void addInterpolant(double x, double factor, const AxisEnds& ends, int first, std::span<double> weights)
{
  const int cell = std::clamp(static_cast<int>(std::floor(x)), ends.low, ends.high - 1);
  const double t = x - cell;
  double w[4] = { ((-0.5 * t + 1.0) * t - 0.5) * t, (1.5 * t - 2.5) * t * t + 1.0,
    ((-1.5 * t + 2.0) * t + 0.5) * t, (0.5 * t - 0.5) * t * t };
  // Samples beyond the ends continue the line through the last two.
  if (cell == ends.low)
  {
    w[1] += 2.0 * w[0];
    w[2] -= w[0];
    w[0] = 0.0;
  }
  if (cell == ends.high - 1)
  {
    w[2] += 2.0 * w[3];
    w[1] -= w[3];
    w[3] = 0.0;
  }
  for (int n = 0; n < 4; ++n)
  {
    const int at = cell - 1 + n - first;
    if (at >= 0 && at < static_cast<int>(weights.size()))
    {
      weights[static_cast<std::size_t>(at)] += factor * w[n];
    }
  }
}

/// The weights at x of the samples from `first` on, not normalized. Nodes stand for what lies half a step
/// around them, of which they count as much as lies between the ends: else weights would jump where x moves a
/// node past an end, and surfaces would have a ring there.
void findWeights(const Kernel& kernel, double x, const AxisEnds& ends, int first, std::span<double> weights)
{
  std::fill(weights.begin(), weights.end(), 0.0);
  const int count = kernel.deviation > 0.0 ? nodes : 0;
  const double step = kernel.deviation * nodesEnd / nodes;
  for (int n = -count; n <= count; ++n)
  {
    const double z = count == 0 ? 0.0 : nodesEnd * n / count;
    const double at = x + kernel.deviation * z;
    const double within = std::min(at - ends.low, ends.high - at);
    const double share = count == 0 ? 1.0 : std::clamp(within / step + 0.5, 0.0, 1.0);
    if (share > 0.0)
    {
      addInterpolant(std::clamp<double>(at, ends.low, ends.high), share * kernel(z), ends, first, weights);
    }
  }
}

double sumOfMagnitudes(std::span<const double> weights)
{
  return std::transform_reduce(
    weights.begin(), weights.end(), 0.0, std::plus<>(), [](double w) { return std::abs(w); });
}

/// The distance, less one, beyond which samples weigh too little to be used.
int findReach(const Kernel& kernel, int subdivision)
{
  const int all = 2 + static_cast<int>(std::ceil(nodesEnd * kernel.deviation));
  std::vector<double> weights(static_cast<std::size_t>(2 * all + 2));
  int reach = 0;
  for (int phase = 0; phase < subdivision; ++phase)
  {
    const double x = static_cast<double>(phase) / subdivision;
    findWeights(kernel, x, {}, -all, weights);
    const double whole = sumOfMagnitudes(weights);
    const auto beyond = [&](int limit)
    {
      double sum = 0.0;
      for (int n = -all; n <= all + 1; ++n)
      {
        sum += std::abs(n - x) >= limit + 1 ? std::abs(weights[static_cast<std::size_t>(n + all)]) : 0.0;
      }
      return sum;
    };
    while (beyond(reach) > negligible * whole)
    {
      ++reach;
    }
  }
  return reach;
}

} // namespace

glm::dvec3 spacingRatios(const GridGeometry& geometry)
{
  glm::dvec3 spacing;
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec3& step = geometry.stepToWorld()[axis];
    spacing[axis] = std::hypot(step.x, step.y, step.z);
  }
  return spacing / std::min({ spacing.x, spacing.y, spacing.z });
}

glm::dvec3 smoothingDeviation(const GridGeometry& geometry, double smoothing)
{
  return smoothing / spacingRatios(geometry);
}

AxisResampling::AxisResampling(double deviation, int subdivision, int samples, SmoothingKernel form)
  : Subdivision(subdivision)
  , Samples(samples)
{
  if (!(deviation >= 0.0 && deviation <= largestDeviation) || subdivision < 1 || samples < 2)
  {
    throw std::invalid_argument(
      "resampling needs a deviation from 0 to 100 samples, a subdivision from 1 and two samples or more");
  }
  const Kernel kernel = { form, deviation };
  const int reach = this->Reach = findReach(kernel, subdivision);
  const int taps = this->Taps = 2 * reach + (subdivision > 1 ? 2 : 1);
  const auto add = [&](double x, const AxisEnds& ends, int first, bool mirrored, std::vector<double>& to)
  {
    to.resize(to.size() + static_cast<std::size_t>(taps));
    const std::span<double> weights = std::span(to).last(static_cast<std::size_t>(taps));
    findWeights(kernel, x, ends, first, weights);
    for (int n = 0; n < taps; ++n)
    {
      // As far on both sides.
      weights[static_cast<std::size_t>(n)] *= std::abs(first + n - x) < reach + 1;
    }
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (double& weight : weights)
    {
      weight /= sum;
    }
    if (mirrored)
    {
      std::reverse(weights.begin(), weights.end());
    }
    this->Gain = std::max(this->Gain, sumOfMagnitudes(weights));
  };
  for (int phase = 0; phase < subdivision; ++phase)
  {
    add(static_cast<double>(phase) / subdivision, {}, -reach, false, this->Inside);
  }
  const int all = this->positions();
  this->LowEnd = std::min(all, reach * subdivision);
  this->HighEnd = std::max(this->LowEnd, (samples - 1 - reach) * subdivision + 1);
  for (int position = 0; position < this->LowEnd; ++position)
  {
    const int sample = position / subdivision;
    const bool both = position > (samples - 1 - reach) * subdivision;
    add(static_cast<double>(position) / subdivision, both ? AxisEnds{ 0, samples - 1 } : AxisEnds{ 0 },
      sample - reach, false, this->Ends);
  }
  for (int position = this->HighEnd; position < all; ++position)
  {
    // From the high end, as if that were the low one.
    const int after = samples - 1 - position / subdivision;
    add(after - static_cast<double>(position % subdivision) / subdivision, { 0 }, after + reach - (taps - 1),
      true, this->Ends);
  }
}

std::span<const double> AxisResampling::weights(int position) const
{
  const std::size_t taps = static_cast<std::size_t>(this->Taps);
  const bool inside = position >= this->LowEnd && position < this->HighEnd;
  const int row = inside      ? position % this->Subdivision
    : position < this->LowEnd ? position
                              : this->LowEnd + position - this->HighEnd;
  return std::span(inside ? this->Inside : this->Ends).subspan(static_cast<std::size_t>(row) * taps, taps);
}

} // namespace ink
