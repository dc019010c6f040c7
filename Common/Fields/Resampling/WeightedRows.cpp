// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/Resampling/WeightedRows.h"

#include "Core/RowGroups.h"

namespace ink
{
namespace
{

/// @param first whether `to` has no sums yet
template <std::size_t rows, bool first, class Work>
void addRows(const Work* __restrict middle, const Work* const* from, const Work* weights, std::size_t count,
  Work* __restrict to)
{
  const Work* row[rows];
  Work weight[rows];
  for (std::size_t n = 0; n < rows; ++n)
  {
    row[n] = from[n];
    weight[n] = weights[n];
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const Work own = middle[i];
    Work sum = first ? own : to[i];
    for (std::size_t n = 0; n < rows; ++n)
    {
      sum += weight[n] * (row[n][i] - own);
    }
    to[i] = sum;
  }
}

} // namespace

template <class Work>
void sumAcross(const Work* middle, const std::vector<const Work*>& rows, const std::vector<Work>& weights,
  std::size_t count, Work* to)
{
  if (rows.empty())
  {
    std::copy_n(middle, count, to);
  }
  const auto add = [&]<std::size_t some>(std::size_t first)
  {
    const auto addSome = first == 0 ? addRows<some, true, Work> : addRows<some, false, Work>;
    addSome(middle, rows.data() + first, weights.data() + first, count, to);
  };
  forEachRowGroup(rows.size(), add);
}

template <class Work>
void sumAlong(const Work* from, int step, const Work* weights, int taps, int reach, int count, Work* to)
{
  const Work* const middle = from + reach * step;
  std::copy_n(middle, count, to);
  // Two at a time: each pass loads and stores the sums once.
  for (int n = 0; n < taps; n += 2)
  {
    const int m = std::min(n + 1, taps - 1);
    const Work* const row = from + n * step;
    const Work* const next = from + m * step;
    const Work* const weight = weights + static_cast<std::ptrdiff_t>(n) * count;
    const Work* const nextWeight = weights + static_cast<std::ptrdiff_t>(m) * count;
    const Work factor = m > n ? Work(1) : Work(0);
#pragma GCC ivdep
    for (int i = 0; i < count; ++i)
    {
      const Work own = middle[i];
      const Work sum = to[i] + weight[i] * (row[i] - own);
      to[i] = sum + factor * nextWeight[i] * (next[i] - own);
    }
  }
}

#define INK_INSTANTIATE(Work)                                                                                \
  template void sumAcross(                                                                                   \
    const Work*, const std::vector<const Work*>&, const std::vector<Work>&, std::size_t, Work*);             \
  template void sumAlong(const Work*, int, const Work*, int, int, int, Work*);
INK_INSTANTIATE(float)
INK_INSTANTIATE(double)
#undef INK_INSTANTIATE

} // namespace ink
