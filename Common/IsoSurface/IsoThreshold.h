// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

namespace ink
{

/// Exact comparisons `sample >= f0` and `sample > f0` with a double f0, as comparisons in the samples' own
/// type.
template <class T>
struct IsoThreshold
{
  /// The smallest T that passes.
  T lowest = 0;
  /// False: no T passes.
  bool reachable = false;

  static IsoThreshold atLeast(double f0)
  {
    if constexpr (std::is_integral_v<T>)
    {
      return smallestInteger(std::ceil(f0));
    }
    else
    {
      const T t = rounded(f0);
      return { static_cast<double>(t) < f0 ? next(t) : t, true };
    }
  }

  static IsoThreshold above(double f0)
  {
    if constexpr (std::is_integral_v<T>)
    {
      const double down = std::floor(f0);
      IsoThreshold bound = smallestInteger(down);
      // The successor of floor(f0) need not be a double, so it is taken as a T.
      if (bound.reachable && down >= static_cast<double>(std::numeric_limits<T>::lowest()))
      {
        bound.reachable = bound.lowest < std::numeric_limits<T>::max();
        bound.lowest += bound.reachable ? 1 : 0;
      }
      return bound;
    }
    else
    {
      const T t = rounded(f0);
      return { static_cast<double>(t) > f0 ? t : next(t), true };
    }
  }

private:
  static IsoThreshold smallestInteger(double value)
  {
    // 2 to the number of value bits: one above the largest T, and a double without rounding.
    const double end = std::ldexp(1.0, std::numeric_limits<T>::digits);
    const double first = static_cast<double>(std::numeric_limits<T>::lowest());
    return value <= first ? IsoThreshold{ std::numeric_limits<T>::lowest(), true }
      : value < end       ? IsoThreshold{ static_cast<T>(value), true }
                          : IsoThreshold{};
  }

  static T rounded(double value)
  {
    constexpr T largest = std::numeric_limits<T>::max();
    constexpr T infinity = std::numeric_limits<T>::infinity();
    return value > largest ? infinity : value < -largest ? -infinity : static_cast<T>(value);
  }
  static T next(T t) { return std::nextafter(t, std::numeric_limits<T>::infinity()); }
};

} // namespace ink
