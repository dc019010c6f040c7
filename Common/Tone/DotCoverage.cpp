// SPDX-License-Identifier: BSD-3-Clause
#include "Tone/DotCoverage.h"

#include <algorithm>
#include <cmath>

namespace ink
{

// A soft dot of radius r covers the integral of clamp(r + 1/2 - distance), that is pi (r^2 + 1/12) for
// r >= 1/2. Smaller ones are dots with r = 1/2, less intense.
DotShape dotShape(float diameter)
{
  constexpr float excess = 1.0f / 12.0f;
  constexpr float leastRadius = 0.5f;
  constexpr float leastSquare = leastRadius * leastRadius + excess;
  const float square = 0.25f * diameter * diameter;
  return { std::sqrt(std::max(square, leastSquare) - excess), std::min(square / leastSquare, 1.0f) };
}

float dotCoverage(const DotShape& dot, float distance)
{
  return dot.intensity * std::clamp(dot.radius + 0.5f - distance, 0.0f, 1.0f);
}

float thinnedIntensity(float intensity, float least, std::uint32_t index)
{
  // Multiples of the golden section modulo 1 fill the unit interval evenly, however many there are.
  constexpr std::uint32_t goldenSection = 2654435769u;
  const float random = static_cast<float>((index * goldenSection) >> 8) * 0x1p-24f;
  return intensity >= least ? intensity : intensity > least * random ? least : 0.0f;
}

} // namespace ink
