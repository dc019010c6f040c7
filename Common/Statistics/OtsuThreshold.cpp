// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/OtsuThreshold.h"

#include <cstddef>

namespace ink
{

double otsuThreshold(const std::vector<std::int64_t>& histogram)
{
  double count = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < histogram.size(); ++i)
  {
    count += static_cast<double>(histogram[i]);
    sum += static_cast<double>(histogram[i]) * static_cast<double>(i);
  }
  double below = 0.0;
  double sumBelow = 0.0;
  double best = -1.0;
  std::size_t first = 0;
  std::size_t last = 0;
  for (std::size_t i = 0; i + 1 < histogram.size(); ++i)
  {
    below += static_cast<double>(histogram[i]);
    sumBelow += static_cast<double>(histogram[i]) * static_cast<double>(i);
    if (below == 0.0 || below == count)
    {
      continue;
    }
    const double difference = sumBelow / below - (sum - sumBelow) / (count - below);
    const double variance = below * (count - below) * difference * difference;
    if (variance > best)
    {
      best = variance;
      first = last = i;
    }
    else if (variance == best)
    {
      last = i;
    }
  }
  return (static_cast<double>(first) + static_cast<double>(last)) / 2;
}

} // namespace ink
