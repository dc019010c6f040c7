// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/ScalarDifference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace ink
{

/// Field values minus the iso-value, in double, scaled by a power of two so that sums and differences of a
/// few of them do not overflow. Signs are exact, except for doubles whose difference is subnormal.
template <class T>
class IsoOffset
{
public:
  explicit IsoOffset(double isoValue)
  {
    if constexpr (Wide)
    {
      // The integer part, to which differences are exact.
      const double end = std::ldexp(1.0, std::numeric_limits<T>::digits);
      const double low = static_cast<double>(std::numeric_limits<T>::lowest());
      const double whole = std::clamp(std::floor(isoValue), low, std::nextafter(end, 0.0));
      this->Base = static_cast<T>(whole);
      this->Iso = isoValue - whole;
    }
    else
    {
      this->Iso = isoValue * Scale;
    }
  }

  double operator()(T value) const
  {
    if constexpr (Wide)
    {
      return difference(value, this->Base) - this->Iso;
    }
    else
    {
      return static_cast<double>(value) * Scale - this->Iso;
    }
  }

  /// What values and the iso-value are multiplied by; except for integers of 64 bits.
  static constexpr double Scale = std::is_same_v<T, double> ? 0x1p-4 : 1.0;

private:
  static constexpr bool Wide = std::is_integral_v<T> && sizeof(T) == 8;

  T Base = 0;
  double Iso = 0.0;
};

} // namespace ink
