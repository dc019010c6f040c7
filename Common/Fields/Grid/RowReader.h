// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

namespace ink
{

template <class T>
class GridField;

/// The marks that readRow sets.
enum SampleMark : std::uint8_t
{
  /// An ordinary sample.
  Plain = 0,
  /// Hidden, NaN or infinite; 0 in the row.
  Missing = 1,
  /// Beyond the limit, so that sums might overflow, or a 64-bit integer that is not exact in double.
  Odd = 2
};

/// Copies samples of one row of a grid, converted to Work.
///
/// @param j, k the row
/// @param begin the first of row.size() samples to read
/// @param marks a SampleMark per sample, same size as `row`; untouched if all samples are plain
/// @return whether a sample is marked
template <class T, class Work>
bool readRow(const GridField<T>& field, int j, int k, int begin, Work limit, std::span<Work> row,
  std::span<std::uint8_t> marks);

} // namespace ink
