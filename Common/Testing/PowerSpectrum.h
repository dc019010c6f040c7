// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace ink
{

/// Of samples on the unit square in a band of frequencies: 1 for independent samples.
struct BandPower
{
  double mean;
  double most; ///< of a single wave
};

/// The power at whole numbers of waves along each side, radially averaged. Blue noise has little below the
/// wave length of its distance, and no direction that stands out.
/// @param from, to the band, in waves for each mean distance of the samples
inline BandPower bandPower(std::span<const glm::dvec3> points, double from, double to)
{
  const double mean = std::sqrt(static_cast<double>(points.size()));
  const int last = static_cast<int>(to * mean);
  double sum = 0.0;
  double most = 0.0;
  int count = 0;
  for (int y = 0; y <= last; ++y)
  {
    for (int x = y > 0 ? -last : 1; x <= last; ++x)
    {
      const double frequency = std::hypot(x, y) / mean;
      if (frequency >= from && frequency < to)
      {
        double real = 0.0;
        double imaginary = 0.0;
        for (const glm::dvec3& p : points)
        {
          const double angle = 2.0 * std::numbers::pi * (x * p.x + y * p.y);
          real += std::cos(angle);
          imaginary += std::sin(angle);
        }
        const double power = (real * real + imaginary * imaginary) / static_cast<double>(points.size());
        sum += power;
        most = std::max(most, power);
        ++count;
      }
    }
  }
  return { sum / count, most };
}

} // namespace ink
