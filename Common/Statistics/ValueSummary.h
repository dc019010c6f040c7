#pragma once

#include <cstdint>
#include <limits>
#include <span>

namespace ink
{

/// What values a volume has; those of parts of it can be joined.
struct ValueSummary
{
  /// Of the finite values; least is greater than greatest if there are none.
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();
  std::uint64_t notFinite = 0; ///< values that are NaN or infinite

  void add(const ValueSummary& other);
};

/// \tparam T any of the scalar types of VTK.
template <typename T>
ValueSummary summarizeValues(std::span<const T> values);

} // namespace ink
