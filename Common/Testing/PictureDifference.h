// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace ink
{

/// The darkness by which pictures of the same size differ, of all that the reference has.
inline double pictureDifference(const std::vector<double>& reference, const std::vector<double>& other)
{
  double difference = 0.0;
  double ink = 0.0;
  for (std::size_t i = 0; i < reference.size(); ++i)
  {
    difference += std::abs(reference[i] - other[i]);
    ink += reference[i];
  }
  return difference / ink;
}

} // namespace ink
