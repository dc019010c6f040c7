// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Derivatives/SeparableKernel.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Internal to Common/Fields: derivatives across rows in which samples may be missing, all of them or some.
namespace ink
{

enum class Derivative
{
  None,
  First,
  Second
};

inline const std::vector<double>& coefficientsOf(const SeparableKernel& kernel, Derivative derivative)
{
  return derivative == Derivative::None ? kernel.smooth
    : derivative == Derivative::First   ? kernel.first
                                        : kernel.second;
}

/// A row of intermediate results and, if `marked`, a mask of the missing ones.
struct Row
{
  double* values;
  std::uint8_t* missing;
  bool* marked;
};

/// Consecutive rows along y or z; null outside the grid.
struct Line
{
  std::vector<Row> rows;

  bool anyMarked() const
  {
    return std::any_of(
      this->rows.begin(), this->rows.end(), [](const Row& row) { return row.values && *row.marked; });
  }
};

/// to += factor * derivative across the rows of a line without missing samples. Computed from differences
/// from the central row, so that derivatives of equal rows are exactly 0.
inline void addAcross(const Line& line, const SeparableKernel& kernel, Derivative derivative, double factor,
  std::size_t count, double* __restrict to)
{
  const std::vector<double>& coefficients = coefficientsOf(kernel, derivative);
  const double* const middle = line.rows[line.rows.size() / 2].values;
  for (std::size_t n = 0; n < line.rows.size(); ++n)
  {
    const double weight = factor * coefficients[n];
    const double* const row = line.rows[n].values;
    if (weight == 0.0)
    {
      continue;
    }
    if (derivative == Derivative::None)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        to[i] += weight * row[i];
      }
    }
    else if (row != middle)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        to[i] += weight * (row[i] - middle[i]);
      }
    }
  }
}

/// The derivative at sample i, with a kernel for the rows in which it is not missing.
inline double acrossAt(const Line& line, const SeparableKernel& kernel, Derivative derivative, std::size_t i)
{
  const std::vector<double>& coefficients = coefficientsOf(kernel, derivative);
  // Relative to a value that is not missing.
  double reference = 0.0;
  double sum = 0.0;
  bool found = false;
  for (std::size_t n = 0; n < line.rows.size(); ++n)
  {
    if (coefficients[n] != 0.0)
    {
      const double value = line.rows[n].values[i];
      reference = found ? reference : value;
      found = true;
      sum += coefficients[n] * (value - reference);
    }
  }
  return derivative == Derivative::None ? reference + sum : sum;
}

inline bool isMissing(const Row& row, std::size_t i)
{
  return !row.values || (*row.marked && row.missing[i]);
}

} // namespace ink
