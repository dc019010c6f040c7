// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

/// Weighted sums of rows, as differences from one of them: sums of equal numbers are exactly that number.
/// Internal to Common/Fields.
namespace ink
{

/// to = middle + sum of weight * (row - middle)
template <class Work>
void sumAcross(const Work* middle, const std::vector<const Work*>& rows, const std::vector<Work>& weights,
  std::size_t count, Work* to);

/// to[i] = middle + sum over taps n of weights[n * count + i] * (from[i + n * step] - middle), with middle
/// from[i + reach * step]
template <class Work>
void sumAlong(const Work* from, int step, const Work* weights, int taps, int reach, int count, Work* to);

} // namespace ink
