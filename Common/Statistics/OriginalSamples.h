// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ink
{

/// Along one axis of a grid that was enlarged, the samples of the one before, in samples of the enlarged one.
struct OriginalSamples
{
  double first = 0.0; ///< where the first one stands; may be between samples
  double step = 1.0;  ///< how far apart they are; 1: all are original
  int count = 0;

  /// The sample of the enlarged grid that stands next to each one.
  /// @param samples of the enlarged grid
  std::vector<int> indices(int samples) const
  {
    std::vector<int> result(static_cast<std::size_t>(this->count));
    for (int i = 0; i < this->count; ++i)
    {
      result[static_cast<std::size_t>(i)] =
        std::clamp(static_cast<int>(std::ceil(this->first + i * this->step - 0.5)), 0, samples - 1);
    }
    return result;
  }
};

} // namespace ink
