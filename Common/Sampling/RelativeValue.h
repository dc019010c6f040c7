#pragma once

#include "Fields/Scalars.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace ink
{

/// Values of the field minus the iso-value, in double, times a power of two that keeps sums and differences
/// of a few of them from overflowing. Their signs are exact, but for doubles that differ by less than any
/// normal one.
template <class T>
class RelativeValue
{
public:
  explicit RelativeValue(double isoValue)
  {
    if constexpr (Wide)
    {
      // The integer next below, so that the difference to it is exact.
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

private:
  static constexpr bool Wide = std::is_integral_v<T> && sizeof(T) == 8;
  static constexpr double Scale = std::is_same_v<T, double> ? 0x1p-4 : 1.0;

  T Base = 0;
  double Iso = 0.0;
};

} // namespace ink
