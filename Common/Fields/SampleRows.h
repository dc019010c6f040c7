#pragma once

#include "Fields/GridField.h"

#include <cstdint>
#include <span>

namespace ink
{

/// Copies samples of one row of a grid, converted to Work, for code that works on whole rows.
///
/// A sample that such code must not touch is marked and becomes 0: a missing one (hidden, NaN or infinite),
/// one beyond `limit`, whose sums might overflow, and a 64-bit integer that is no double.
///
/// \param j, k   the row
/// \param begin  its first sample that is wanted; row.size() samples follow
/// \param marks  of the size of `row`, 1 for a marked sample and 0 otherwise; untouched where none is marked
/// \returns whether a sample is marked
template <class T, class Work>
bool readRow(const GridField<T>& field, int j, int k, int begin, Work limit, std::span<Work> row,
  std::span<std::uint8_t> marks);

} // namespace ink
