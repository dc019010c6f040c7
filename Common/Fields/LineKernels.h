#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// How many steps beyond a sample the kernels here reach: four deviations, at least 2.
int lineReach(double deviation);

/// Smoothed value and derivatives of samples along a line, as sums of samples[n] * coefficient[n] over the
/// offsets -reach ... reach. The value is the mean weighted by a Gaussian, the derivatives, per step and step
/// squared, are those of the parabola that fits best with the same weights; of a straight line where there
/// are but two samples, and 0 where there are fewer.
struct LineKernel
{
  /// Whether there are samples in the middle of the Gaussian, without which there is no value. Otherwise all
  /// coefficients are 0.
  bool exists = false;
  std::vector<double> smooth;
  std::vector<double> first;
  std::vector<double> second;

  /// \param deviation of the Gaussian, in steps
  /// \param used not 0 for the samples that there are, 2 * lineReach(deviation) + 1 of them
  LineKernel(double deviation, std::span<const std::uint8_t> used);
};

/// The kernels for all places of a sample relative to the ends of a line: near one of them some offsets lead
/// beyond it.
class LineKernels
{
public:
  /// \param samples on the line
  LineKernels(double deviation, int samples);

  int reach() const { return this->Reach; }
  double deviation() const { return this->Deviation; }
  const LineKernel& operator[](int sample) const;

private:
  double Deviation;
  int Reach;
  int Samples;
  std::vector<LineKernel> Kernels;
};

} // namespace ink
