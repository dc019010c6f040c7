// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>
#include <string>

namespace ink
{

/// A number as people write it: up to 7 significant digits.
inline std::string text(double number)
{
  std::ostringstream stream;
  stream.precision(7);
  // Plus zero: no -0.
  stream << number + 0.0;
  return stream.str();
}

/// "a x b x c" from three numbers.
inline std::string dimensionsText(const int dimensions[3])
{
  return std::to_string(dimensions[0]) + " x " + std::to_string(dimensions[1]) + " x " +
    std::to_string(dimensions[2]);
}

/// "a b c" from three numbers.
inline std::string tripleText(const double v[3])
{
  return text(v[0]) + " " + text(v[1]) + " " + text(v[2]);
}

} // namespace ink
