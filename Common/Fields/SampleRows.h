#pragma once

#include "Fields/GridField.h"

#include <cstdint>
#include <span>

namespace ink
{

/// What readRow marks samples with.
enum SampleMark : std::uint8_t
{
  /// Nothing to say.
  Plain = 0,
  /// Hidden, NaN or infinite. It is 0 in the row.
  Missing = 1,
  /// Beyond the limit, so that sums might overflow, or a 64-bit integer that is no double.
  Odd = 2
};

/// Copies samples of one row of a grid, converted to Work, for code that works on whole rows.
///
/// \param j, k   the row
/// \param begin  its first sample that is wanted; row.size() samples follow
/// \param marks  of the size of `row`, a SampleMark for each; untouched where all are plain
/// \returns whether a sample is marked
template <class T, class Work>
bool readRow(const GridField<T>& field, int j, int k, int begin, Work limit, std::span<Work> row,
  std::span<std::uint8_t> marks);

} // namespace ink
