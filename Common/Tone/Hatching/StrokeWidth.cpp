// SPDX-License-Identifier: BSD-3-Clause
#include "Tone/Hatching/StrokeWidth.h"

#include <algorithm>
#include <cmath>

namespace ink::hatching
{

namespace
{

/// Strokes fade over priorities from 1 - fading to 1 + fading times the fraction that is drawn.
constexpr float fading = 0.25f;
/// In lighter tones than this strokes get thinner than the least width, and no fewer: so they end in points.
constexpr float thinning = 0.1f;

} // namespace

float StrokeWidth::coverage(float tone, int family) const
{
  const float single = 1.0f - this->crosshatching;
  if (tone <= single)
  {
    return family == 0 ? tone : 0.0f;
  }
  // What the first family leaves white up to `single`, and then each.
  const float left = std::sqrt(std::max(1.0f - tone, 0.0f) / (1.0f - single));
  return family == 0 ? 1.0f - (1.0f - single) * left : 1.0f - left;
}

float StrokeWidth::width(float coverage, float allSpacing, float priority) const
{
  if (!(coverage > 0.0f && allSpacing > 0.0f))
  {
    return 0.0f;
  }
  const float wanted = std::max(this->spacing, this->leastWidth / std::max(coverage, thinning));
  const float fraction = allSpacing / wanted;
  const float from = (1.0f - fading) * fraction;
  const float to = (1.0f + fading) * fraction;
  const float range = to - from;
  // The integral of what is left of strokes over all priorities, the fraction unless they run out.
  const float beyond = std::max(to - 1.0f, 0.0f);
  const float drawn = from >= 1.0f ? 1.0f : fraction - 0.5f * beyond * beyond / range;
  return coverage * allSpacing / drawn * std::clamp((to - priority) / range, 0.0f, 1.0f);
}

float StrokeWidth::mostPriority(float allSpacing) const
{
  return (1.0f + fading) * allSpacing / this->spacing;
}

} // namespace ink::hatching
