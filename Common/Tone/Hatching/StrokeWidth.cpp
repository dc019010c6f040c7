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
/// Of which spacings are known by position: from all strokes in full on.
constexpr float firstFraction = 1.0f / (1.0f - fading);
constexpr float perOctave = 2.0f;

} // namespace

float presence(float fraction, float priority)
{
  return std::clamp(((1.0f + fading) * fraction - priority) / (2.0f * fading * fraction), 0.0f, 1.0f);
}

float drawnShare(float fraction)
{
  const float beyond = std::max((1.0f + fading) * fraction - 1.0f, 0.0f);
  return (1.0f - fading) * fraction >= 1.0f ? 1.0f : fraction - 0.25f * beyond * beyond / (fading * fraction);
}

float spacingFraction(std::size_t index)
{
  return firstFraction * std::exp2(-static_cast<float>(index) / perOctave);
}

float spacingRatio(const SpacingRatios& ratios, float fraction)
{
  constexpr float last = static_cast<float>(evenSpacing.size() - 1);
  const float at = std::clamp(perOctave * std::log2(firstFraction / fraction), 0.0f, last);
  const auto before = static_cast<std::size_t>(std::min(at, last - 1.0f));
  return std::lerp(ratios[before], ratios[before + 1], at - static_cast<float>(before));
}

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

float mostSpacingRatio(float cosine)
{
  return 1.0f + 2.0f * std::abs(cosine);
}

float StrokeWidth::width(
  float coverage, float allSpacing, float priority, const SpacingRatios& ratios, float cosine) const
{
  if (!(coverage > 0.0f && allSpacing > 0.0f))
  {
    return 0.0f;
  }
  const float fraction =
    allSpacing / std::max(this->spacing, this->leastWidth / std::max(coverage, thinning));
  return coverage * allSpacing / drawnShare(fraction) * presence(fraction, priority) *
    std::min(spacingRatio(ratios, fraction), mostSpacingRatio(cosine));
}

float StrokeWidth::mostPriority(float allSpacing) const
{
  return (1.0f + fading) * allSpacing / this->spacing;
}

} // namespace ink::hatching
