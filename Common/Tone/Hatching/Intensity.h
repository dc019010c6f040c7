// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ink::hatching
{

/// How dark a surface is to be drawn (Rössl et al. 2000, section 3.2): the convex combination of a diffuse
/// and a silhouette term, each with a truncation level, so that nothing is drawn where there is hardly any.
/// The reference for Rendering/Strokes/Shaders/InkHatching.glsl, which computes the same.
struct Intensity
{
  float silhouetteWeight = 0.3f;     ///< of the silhouette term; the rest is the diffuse one's. 0 to 1
  float diffuseTruncation = 0.1f;    ///< 0 to 1
  float silhouetteTruncation = 0.5f; ///< 0 to 1
  /// What becomes of a middle tone (Schlick 1994, bias): darker with a larger one. 0 to 1; at 0.5 tones stay.
  float bias = 0.5f;
  float darkest = 0.85f; ///< the tone of the deepest shadow, 0 to 1

  /// The share of the paper that ink is to cover, 0 to 1.
  /// @param lit how much light falls there, 0 to 1: the paper's diffuse light
  /// @param cosine of the angle between the normal and the direction to the eye; its sign does not matter
  float tone(float lit, float cosine) const;
};

/// What is left of an intensity above a level: 0 up to there and 1 for 1, without a step, which would pop.
float truncated(float intensity, float level);

} // namespace ink::hatching
