// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ink::stipple
{

/// How fractions of stipples are drawn, in particular where elements are too small for a pattern (Lu et al.
/// 2003, section 5.2): with the same gray at any size, in either of the paper's two ways.
struct SmallElements
{
  enum class Way
  {
    intensity,  ///< a fraction of a stipple is a stipple of that intensity
    probability ///< an element's random value decides whether it is a whole stipple
  };
  Way way = Way::intensity;

  /// N_max below which elements count as small, 2 to 9: the paper's minimum coverage in pixels, where N_max
  /// is one stipple a pixel.
  float minimumCoverage = 9.0f;

  /// The fraction of a stipple over which stipples of larger elements fade in, 0 (suddenly) to 1 (gradually).
  float fade = 1.0f;

  /// How small elements are: 0 from minimumCoverage on up, 1 where only one stipple fits or less. The paper's
  /// weight of the random value, which grows with the object's distance.
  /// @param maximumStipples N_max at the object's center, or where the object's half range lies if that is
  /// farther
  float weight(float maximumStipples) const;

  /// The fraction of a stipple that is drawn, 0 to 1. Summed over the ranks 0, 1, 2 ... (and, with
  /// probability, averaged over the random values), that is `tone` if either the weight or the fade is 1, and
  /// rounded tone at worst; it is 0 for tone 0.
  /// @param tone T, the number of stipples that the element should have
  /// @param rank of the stipple in its element's list, from 0
  /// @param random the element's own value, uniform in [0, 1)
  /// @param weightOfSmall as `weight` gives it
  float part(float tone, int rank, float random, float weightOfSmall) const;
};

} // namespace ink::stipple
