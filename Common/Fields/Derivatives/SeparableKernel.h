// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// The kernels' radius in samples: four standard deviations, at least 2.
int separableReach(double deviation);

/// Smoothed value and derivatives along one axis, as sums of samples[n] * coefficient[n] over the offsets
/// -reach ... reach. The value is the mean weighted by a Gaussian; the derivatives, per step and step
/// squared, are those of the parabola fitted by least squares with the same weights: of a line where only two
/// samples exist, and 0 where fewer do.
struct SeparableKernel
{
  /// Whether samples exist near the Gaussian's center, without which there is no value and all coefficients
  /// are 0.
  bool exists = false;
  std::vector<double> smooth;
  std::vector<double> first;
  std::vector<double> second;

  /// @param deviation the Gaussian's standard deviation, in samples
  /// @param used nonzero for samples that exist; 2 * separableReach(deviation) + 1 values
  SeparableKernel(double deviation, std::span<const std::uint8_t> used);
};

/// The kernels for all positions of a sample relative to the ends of a row, near which some offsets lie
/// outside.
class SeparableKernels
{
public:
  /// @param samples the number of samples along the axis
  SeparableKernels(double deviation, int samples);

  int reach() const { return this->Reach; }
  double deviation() const { return this->Deviation; }
  const SeparableKernel& operator[](int sample) const;

private:
  double Deviation;
  int Reach;
  int Samples;
  std::vector<SeparableKernel> Kernels;
};

} // namespace ink
