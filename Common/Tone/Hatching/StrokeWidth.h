// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

namespace ink::hatching
{

/// Of all strokes: how much of a stroke is drawn where a fraction of them is, in [0, 1]. Strokes fade over a
/// range of priorities, so that none pops.
float presence(float fraction, float priority);

/// The mean of that over all priorities: the fraction, unless strokes run out.
float drawnShare(float fraction);

/// How far strokes are from each other around a position, relative to the mean of all of the surface: when as
/// large a fraction of them is drawn as spacingFraction tells for each of these numbers.
using SpacingRatios = std::array<float, 8>;
inline constexpr SpacingRatios evenSpacing{ 1.0f, 1.0f, 1.0f, 1.0f, 1.0f, 1.0f, 1.0f, 1.0f };

/// Of the least at which all strokes are drawn in full down to a tenth, two in an octave.
float spacingFraction(std::size_t index);

/// The same for any fraction: linear in its logarithm, and constant beyond the ends.
float spacingRatio(const SpacingRatios& ratios, float fraction);

/// No more than this where the surface is seen at that cosine between its normal and the direction to the
/// eye: beside a silhouette wide strokes would reach over it.
float mostSpacingRatio(float cosine);

/// How strokes make a tone: which of them are drawn, and how wide. Of evenly spaced strokes with priorities,
/// of which every prefix is evenly spaced, as large a fraction is drawn as the picture has room for (Rössl et
/// al. 2000, section 3.2, has one for all of a surface), and their widths make up the tone. The reference for
/// Rendering/Strokes/Shaders/InkHatching.glsl, which computes the same.
struct StrokeWidth
{
  float spacing = 6.0f; ///< of the strokes that are drawn, pixels; positive
  /// Lighter tones have fewer strokes of this width instead of thinner ones, pixels; but the lightest ones,
  /// below .1, have thinner ones, so that strokes end in points where they fade.
  float leastWidth = 0.8f;
  /// 0: all ink is the first family's; 1: half is the second's in all tones; between: in tones above
  /// 1 - crosshatching.
  float crosshatching = 0.5f;

  /// The share of the paper that strokes of a family are to cover: both together cover `tone` of it where
  /// they cross at random, 1 - tone = (1 - first) (1 - second). Both grow with the tone.
  /// @param family 0, or 1 for the second
  float coverage(float tone, int family) const;

  /// A stroke's width in pixels at a point; 0: it is not drawn there. It falls smoothly to that over a range
  /// of priorities, so that strokes taper, and none pops.
  /// @param coverage as above
  /// @param allSpacing the distance of all strokes of the family from each other there, pixels
  /// @param priority of the stroke: the share of the family's length that comes before it
  /// @param ratios what strokes that are not even make of their distance there
  /// @param cosine of the angle between the surface's normal and the direction to the eye
  float width(float coverage, float allSpacing, float priority, const SpacingRatios& ratios = evenSpacing,
    float cosine = 1.0f) const;

  /// No stroke with a larger priority is drawn where all strokes are that far from each other, or less.
  float mostPriority(float allSpacing) const;
};

} // namespace ink::hatching
