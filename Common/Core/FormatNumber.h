// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>
#include <string>

namespace ink
{

/// A number as people write it: up to 7 significant digits.
inline std::string formatNumber(double number)
{
  std::ostringstream stream;
  stream.precision(7);
  // Plus zero: no -0.
  stream << number + 0.0;
  return stream.str();
}

/// "a x b x c" from three numbers.
inline std::string formatDimensions(const int dimensions[3])
{
  return std::to_string(dimensions[0]) + " x " + std::to_string(dimensions[1]) + " x " +
    std::to_string(dimensions[2]);
}

/// "a b c" from three numbers.
inline std::string formatTriple(const double v[3])
{
  return formatNumber(v[0]) + " " + formatNumber(v[1]) + " " + formatNumber(v[2]);
}

} // namespace ink
