// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>

/// Calls MACRO(type) for every scalar type that a volume may have.
#define INK_FOR_EACH_SCALAR(MACRO)                                                                           \
  MACRO(char)                                                                                                \
  MACRO(signed char)                                                                                         \
  MACRO(unsigned char)                                                                                       \
  MACRO(short)                                                                                               \
  MACRO(unsigned short)                                                                                      \
  MACRO(int)                                                                                                 \
  MACRO(unsigned int)                                                                                        \
  MACRO(long)                                                                                                \
  MACRO(unsigned long)                                                                                       \
  MACRO(long long)                                                                                           \
  MACRO(unsigned long long)                                                                                  \
  MACRO(float)                                                                                               \
  MACRO(double)

namespace ink
{

/// a - b as a double. 64-bit integers are subtracted before they are rounded, so that neighboring values
/// near the ends of their range stay apart.
template <class T>
double difference(T a, T b)
{
  if constexpr (std::is_integral_v<T> && sizeof(T) == 8)
  {
    using Unsigned = std::make_unsigned_t<T>;
    return a < b ? -static_cast<double>(static_cast<Unsigned>(b) - static_cast<Unsigned>(a))
                 : static_cast<double>(static_cast<Unsigned>(a) - static_cast<Unsigned>(b));
  }
  else
  {
    return static_cast<double>(a) - static_cast<double>(b);
  }
}

} // namespace ink
