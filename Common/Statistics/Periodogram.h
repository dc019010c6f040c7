// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace ink
{

/// How much of several series repeats how often: the squared magnitude of their Fourier transforms, averaged,
/// so that it does not matter whether they repeat at the same places.
class Periodogram
{
public:
  /// A series is centered around 0, and faded in and out by a Hann window.
  /// @param begin the place of the first value
  /// @param values 2 or more
  void add(std::size_t begin, std::vector<double> values);

  /// @param frequency how often something repeats from one value to the next, up to .5
  double power(double frequency) const;
  double amplitude(double frequency) const;

  /// Where the first maximum of what repeats so often is, from place 0 on, of all series together.
  double firstMaximum(double frequency) const;

  struct Peak
  {
    double frequency = 0.0;
    double amplitude = 0.0;  ///< of what repeats so often, root mean square over the series
    double prominence = 0.0; ///< how many times as high it is as the median of what is around it
  };
  /// The most prominent one, or one of which it is a multiple with half of its amplitude or more: what
  /// repeats in jumps does so at multiples of its frequency, too.
  /// @param lowest, highest frequencies to look at
  /// @param length of the longest series, about
  /// @return prominence 0 if there is no series
  Peak findPeak(double lowest, double highest, int length) const;

private:
  struct Series
  {
    std::size_t begin;
    std::vector<double> values;
    std::complex<double> transform(double frequency) const;
  };
  std::vector<Series> All;
};

} // namespace ink
