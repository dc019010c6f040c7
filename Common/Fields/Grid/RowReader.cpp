// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/Grid/RowReader.h"

#include "Fields/Grid/GridField.h"
#include "Fields/ScalarDifference.h"

#include <cmath>
#include <type_traits>

namespace ink
{
namespace
{

/// Whether row code may use the value; `converted` is the value itself.
template <class T, class Work>
bool isPlain(T value, Work converted, Work limit)
{
  if constexpr (std::is_floating_point_v<T>)
  {
    return std::abs(converted) < limit;
  }
  else if constexpr (sizeof(T) == 8)
  {
    constexpr T exact = T(1) << 53;
    return value <= exact && (std::is_unsigned_v<T> || value >= T(0) - exact);
  }
  return true;
}

/// @return whether every value is plain
template <class T, class Work>
bool convert(const T* __restrict from, std::size_t stride, std::size_t count, Work limit, Work* __restrict to)
{
  // An integer instead of a bool, so that compilers vectorize the loop.
  unsigned odd = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const T value = from[i * stride];
    to[i] = static_cast<Work>(value);
    odd |= !isPlain(value, to[i], limit);
  }
  return odd == 0;
}

} // namespace

template <class T, class Work>
bool readRow(const GridField<T>& field, int j, int k, int begin, Work limit, std::span<Work> row,
  std::span<std::uint8_t> marks)
{
  const std::size_t first = field.geometry().offset({ begin, j, k });
  const std::size_t stride = field.stride();
  const T* const values = field.data() + first * stride;
  const bool plain = stride == 1 ? convert(values, 1, row.size(), limit, row.data())
                                 : convert(values, stride, row.size(), limit, row.data());
  const ElementMarks& hidden = field.hidden();
  unsigned anyHidden = 0;
  if (!hidden.empty())
  {
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      anyHidden |= hidden.bytes[first + i] & hidden.mask;
    }
  }
  if (plain && !anyHidden)
  {
    return false;
  }
  for (std::size_t i = 0; i < row.size(); ++i)
  {
    const bool missing = !std::isfinite(row[i]) || (anyHidden && hidden[first + i]);
    marks[i] = missing ? Missing : isPlain(values[i * stride], row[i], limit) ? Plain : Odd;
    row[i] = missing ? Work(0) : row[i];
  }
  return true;
}

#define INK_INSTANTIATE(T)                                                                                   \
  template bool readRow(                                                                                     \
    const GridField<T>&, int, int, int, float, std::span<float>, std::span<std::uint8_t>);                   \
  template bool readRow(                                                                                     \
    const GridField<T>&, int, int, int, double, std::span<double>, std::span<std::uint8_t>);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
