// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Tone/Stipple/Tone.h"

#include <span>
#include <string_view>

namespace ink::stipple
{

/// The few controls that set many of the k's at once (Lu et al. 2003, section 6), each 0 to 1. They switch no
/// enhancement off: at its ends a slider gives what it gives close to them.
struct Sliders
{
  /// Emphasis on boundaries: k_gc, k_gs. More ink.
  float gradient = 0.5f;
  /// Sharpness of boundaries, silhouettes and shades: k_ge, k_se, k_le. Less ink, in a smaller region.
  float sharpness = 0.5f;
  /// How much silhouettes and light count: k_ss, k_le; 0: hardly at all. More contrast between the middle and
  /// the rim.
  float orientation = 0.5f;
  /// How much nearer parts stand out: k_de and the stipples' size; 0: only what lies at the very ends.
  float distance = 0.5f;
  /// How see-through weak boundaries are: k_ie and the stipples' size; 0: not at all. Less ink.
  float interior = 0.5f;
  /// How far warm and cool colors replace the ink; 0: not at all. The same number of stipples.
  float color = 0.0f;

  /// Sets the k's named above, k_le as the tone's ink wants it, dark or light, and switches the enhancements
  /// on that they belong to; all else stays.
  void apply(Tone& tone) const;
};

/// A kind of drawing to start from.
struct Preset
{
  std::string_view name;
  Sliders sliders;
  bool sizesInPixels; ///< the next two, and not in pixels of a picture that is 1000 pixels high
  float pixelsPerStipple;
  float diameter;
  bool fadeBySize;
  float slantExponent;
  float valueEffect;
  bool lightInk; ///< white ink on black paper

  void apply(Tone& tone) const;
};

/// anatomy (the first: the default), bone, soft-tissue, engineering, plate-white-on-black, as-published: all
/// sliders in the middle, nothing in T but Table 1 and one stipple a pixel, each with a pixel's area.
std::span<const Preset> presets();

/// The preset of that name, or null; capitals and what separates words do not count.
const Preset* findPreset(std::string_view name);

} // namespace ink::stipple
