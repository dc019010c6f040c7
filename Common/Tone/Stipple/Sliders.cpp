// SPDX-License-Identifier: BSD-3-Clause
#include "Tone/Stipple/Sliders.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace ink::stipple
{

namespace
{

/// 0 at 0, 1 in the middle, 4 at the upper end.
float gain(float slider)
{
  return slider <= 0.5f ? 2.0f * slider : 1.0f + 6.0f * (slider - 0.5f);
}

/// 1/4 at 0, 1 in the middle, 4 at the upper end.
float octaves(float slider)
{
  return std::exp2(4.0f * (slider - 0.5f));
}

constexpr float mostExponent = 20.0f;
constexpr float leastExponent = 0.05f;

float exponent(float value)
{
  return std::clamp(value, leastExponent, mostExponent);
}

/// The same of a quotient, also where nothing is divided by.
float exponentOver(float numerator, float denominator)
{
  return denominator > 0.0f ? exponent(numerator / denominator) : mostExponent;
}

/// Of a name, in lower case.
std::string lettersOf(std::string_view name)
{
  std::string letters;
  for (const char c : name)
  {
    const char lower = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (lower >= 'a' && lower <= 'z')
    {
      letters += lower;
    }
  }
  return letters;
}

constexpr Preset presetTable[] = {
  { "anatomy", { 0.5f, 0.5f, 0.5f, 0.15f, 0.15f, 0.0f }, false, 6.0f, 2.2f, true, 1.0f, 0.25f, false },
  { "bone", { 0.65f, 0.6f, 0.5f, 0.15f, 0.35f, 0.0f }, false, 6.0f, 2.2f, true, 1.0f, 0.25f, false },
  { "soft-tissue", { 0.45f, 0.3f, 0.5f, 0.1f, 0.05f, 0.0f }, false, 7.0f, 1.8f, false, 1.0f, 0.25f, false },
  { "engineering", { 0.5f, 0.65f, 0.75f, 0.05f, 0.15f, 0.0f }, false, 7.0f, 2.0f, true, 0.8f, 0.25f, false },
  { "plate-white-on-black", { 0.6f, 0.5f, 0.5f, 0.2f, 0.15f, 0.0f }, false, 7.0f, 2.2f, true, 1.0f, 0.25f,
    true },
  { "as-published", { 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.0f }, true, 1.0f, 1.13f, false, 1.0f, 1.0f, false },
};

} // namespace

void Sliders::apply(Tone& tone) const
{
  const auto limited = [](float slider) { return std::clamp(slider, 0.0f, 1.0f); };
  const float sharp = octaves(limited(this->sharpness));

  tone.boundary.on = true;
  tone.boundary.base = 0.1f + 0.5f * limited(this->gradient);
  tone.boundary.gain = 0.65f * gain(limited(this->gradient));
  tone.boundary.exponent = exponent(0.8f * sharp);

  const float turned = gain(limited(this->orientation));
  tone.silhouette.on = true;
  tone.silhouette.gain = 1.6f * turned;
  tone.silhouette.exponent = exponent(0.5f / sharp);
  tone.lighting.on = true;
  // Light takes dark ink away and is what light ink shows: less ink with a smaller exponent, or a larger one.
  tone.lighting.exponent =
    tone.lighting.lightInk ? exponent(sharp * turned) : exponentOver(1.0f, sharp * turned);

  tone.distance.on = true;
  tone.distance.exponent = exponentOver(0.5f, limited(this->distance));
  tone.distance.size = limited(this->distance);

  tone.interior.on = true;
  tone.interior.exponent = 2.0f * limited(this->interior);
  tone.interior.size = limited(this->interior);

  tone.warmCool.amount = limited(this->color);
}

void Preset::apply(Tone& tone) const
{
  tone.lighting.lightInk = this->lightInk;
  this->sliders.apply(tone);
  tone.pixelsPerStipple = this->pixelsPerStipple;
  tone.diameter = this->diameter;
  tone.fadeBySize = this->fadeBySize;
  tone.resolution.slantExponent = this->slantExponent;
  tone.valueEffect = this->valueEffect;
}

std::span<const Preset> presets()
{
  return presetTable;
}

const Preset* findPreset(std::string_view name)
{
  const std::string letters = lettersOf(name);
  const auto* found = std::find_if(std::begin(presetTable), std::end(presetTable),
    [&](const auto& p) { return lettersOf(p.name) == letters; });
  return found == std::end(presetTable) ? nullptr : found;
}

} // namespace ink::stipple
