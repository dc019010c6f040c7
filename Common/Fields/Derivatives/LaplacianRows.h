// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace ink
{

/// The loops behind ink::laplacianOfGaussian, over one row at a time, in a form that compilers vectorize.
/// Kernels are those of samples without missing neighbors: symmetric, so that only one side is given. All
/// functions work on differences from the central row, so that derivatives of equal rows are exactly 0 and
/// their mean is exactly the row.

/// The central row of a kernel and the rows n + 1 steps before and after it.
struct RowPairs
{
  const double* middle = nullptr;
  std::vector<const double*> before;
  std::vector<const double*> after;
};

/// One side of a symmetric kernel, from the nearest neighbor on.
using HalfKernel = std::vector<double>;

/// value = the mean with weights `smooth`; curve = the second derivative.
void smoothAndBend(const RowPairs& rows, const HalfKernel& smooth, const HalfKernel& second,
  std::size_t count, double* value, double* curve);

/// to += the mean.
void addSmooth(const RowPairs& rows, const HalfKernel& smooth, std::size_t count, double* to);

/// to += the second derivative.
void addBend(const RowPairs& rows, const HalfKernel& second, std::size_t count, double* to);

/// to += the first derivative.
void addSlope(const RowPairs& rows, const HalfKernel& first, std::size_t count, double* to);

} // namespace ink
