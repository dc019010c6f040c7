// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/Derivatives/LaplacianRows.h"

#include "Core/RowGroups.h"

#include <algorithm>

namespace ink
{
namespace
{

/// The outputs to compute.
enum class Part
{
  Mean,
  Bend,
  Both
};

template <Part part, std::size_t pairs>
void addPairs(const double* __restrict middle, const double* const* before, const double* const* after,
  const double* smooth, const double* second, std::size_t count, double* __restrict value,
  double* __restrict curve)
{
  const double* low[pairs];
  const double* high[pairs];
  double weight[pairs];
  double bend[pairs];
  for (std::size_t n = 0; n < pairs; ++n)
  {
    low[n] = before[n];
    high[n] = after[n];
    weight[n] = part == Part::Bend ? 0.0 : smooth[n];
    bend[n] = part == Part::Mean ? 0.0 : second[n];
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const double own = middle[i];
    double mean = part == Part::Bend ? 0.0 : value[i];
    double curvature = part == Part::Mean ? 0.0 : curve[i];
    for (std::size_t n = 0; n < pairs; ++n)
    {
      const double d = (high[n][i] - own) + (low[n][i] - own);
      if constexpr (part != Part::Bend)
      {
        mean += weight[n] * d;
      }
      if constexpr (part != Part::Mean)
      {
        curvature += bend[n] * d;
      }
    }
    if constexpr (part != Part::Bend)
    {
      value[i] = mean;
    }
    if constexpr (part != Part::Mean)
    {
      curve[i] = curvature;
    }
  }
}

template <Part part>
void addAllPairs(const RowPairs& rows, const double* smooth, const double* second, std::size_t count,
  double* value, double* curve)
{
  const auto add = [&]<std::size_t pairs>(std::size_t first)
  {
    addPairs<part, pairs>(rows.middle, rows.before.data() + first, rows.after.data() + first,
      smooth ? smooth + first : nullptr, second ? second + first : nullptr, count, value, curve);
  };
  forEachRowGroup(rows.before.size(), add);
}

} // namespace

void smoothAndBend(const RowPairs& rows, const HalfKernel& smooth, const HalfKernel& second,
  std::size_t count, double* value, double* curve)
{
  std::copy_n(rows.middle, count, value);
  std::fill_n(curve, count, 0.0);
  addAllPairs<Part::Both>(rows, smooth.data(), second.data(), count, value, curve);
}

void addSmooth(const RowPairs& rows, const HalfKernel& smooth, std::size_t count, double* __restrict to)
{
  const double* const middle = rows.middle;
  for (std::size_t i = 0; i < count; ++i)
  {
    to[i] += middle[i];
  }
  addAllPairs<Part::Mean>(rows, smooth.data(), nullptr, count, to, nullptr);
}

void addBend(const RowPairs& rows, const HalfKernel& second, std::size_t count, double* to)
{
  addAllPairs<Part::Bend>(rows, nullptr, second.data(), count, nullptr, to);
}

void addSlope(const RowPairs& rows, const HalfKernel& first, std::size_t count, double* __restrict to)
{
  for (std::size_t n = 0; n < rows.before.size(); ++n)
  {
    const double* const before = rows.before[n];
    const double* const after = rows.after[n];
    const double weight = first[n];
    for (std::size_t i = 0; i < count; ++i)
    {
      to[i] += weight * (after[i] - before[i]);
    }
  }
}

} // namespace ink
