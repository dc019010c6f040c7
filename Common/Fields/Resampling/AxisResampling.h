// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace ink
{

class GridGeometry;

/// The standard deviation along each axis, in samples, of a Gaussian that is the same in all world
/// directions.
/// @param smoothing in multiples of the smallest distance of samples
glm::dvec3 smoothingDeviation(const GridGeometry& geometry, double smoothing);

/// The distances of samples along the three axes in multiples of the smallest.
glm::dvec3 spacingRatios(const GridGeometry& geometry);

/// The kernels that smooth.
enum class SmoothingKernel
{
  Gaussian,
  /// The Gaussian of fourth order, (3 - x^2 / deviation^2) / 2 times the Gaussian: it keeps parabolas, and so
  /// the height of ridges, and removes less noise (Wand and Jones, "Kernel Smoothing", 1995, section 2.8).
  FourthOrder
};

/// The weights that make of the samples along one axis values at positions between them, smoothed or not: a
/// Gaussian mean of the cubic interpolant of Catmull and Rom ("A class of local interpolating splines", 1974;
/// Keys 1981, a = -1/2), which is linear towards samples beyond the axis' ends; of the Gaussian that part is
/// used that lies between the ends. A deviation of 0 interpolates; weights always sum to one, and lines stay
/// lines at a distance from the ends.
///
/// Position p lies at sample p / subdivision. Its weights belong to the samples from
/// p / subdivision - reach() (rounded down) on; those of samples beyond the ends are 0. Weights depend on the
/// distances from the ends and on nothing else, so that parts of an axis agree bitwise where no weight
/// belongs to a sample that one of them lacks.
class AxisResampling
{
public:
  /// @param deviation the Gaussian's standard deviation in samples, from 0
  /// @param subdivision positions per sample, from 1
  /// @param samples the number of samples along the axis, from 2
  /// @throws std::invalid_argument when one of them is out of range
  AxisResampling(
    double deviation, int subdivision, int samples, SmoothingKernel form = SmoothingKernel::Gaussian);

  int subdivision() const { return this->Subdivision; }
  int samples() const { return this->Samples; }
  /// (samples - 1) * subdivision + 1
  int positions() const { return (this->Samples - 1) * this->Subdivision + 1; }
  /// Samples used before the one at or before a position; after it there may be one more.
  int reach() const { return this->Reach; }
  /// The number of weights of a position.
  int taps() const { return this->Taps; }
  std::span<const double> weights(int position) const;
  /// The greatest sum of a position's absolute weights: how far values can overshoot those of the samples.
  double gain() const { return this->Gain; }

private:
  int Subdivision;
  int Samples;
  int Reach;
  int Taps;
  double Gain = 1.0;
  std::vector<double> Inside; ///< weights by phase, where all samples are there
  std::vector<double> Ends;   ///< weights of the positions near the ends, in order
  int LowEnd;                 ///< the first position that is not near the low end
  int HighEnd;                ///< the first position after that is near the high end
};

} // namespace ink
