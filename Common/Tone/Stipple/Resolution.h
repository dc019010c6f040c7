// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ink::stipple
{

/// Resolution enhancement (Lu et al. 2003, section 5.2 and Table 1, row 3): as many stipples as an element's
/// projection has room for, so that the pattern is as dense far away as close by.
struct Resolution
{
  bool on = true;
  float exponent =
    -2.0f; ///< not positive, so that the factor is subtractive; -2: as perspective shrinks areas
  float slantExponent = 1.0f; ///< 1: as slanted areas appear smaller; 0: whatever the slant; not negative

  /// ((D_near + d_i) / (D_near + d_0))^k_rc, the part by distance; 1 if this enhancement is off. What is
  /// nearer than d_0 has more room in proportion to its own projection, on or off.
  /// @param distance D_near + d_i: the element's distance from the eye along the view
  /// @param nearest D_near + d_0: the object's nearest point's, see nearestDistance; positive
  float distanceFactor(float distance, float nearest) const;

  /// D_near + d_0, which Table 1 has for objects seen from outside: of those around the eye or just before it
  /// no less than half their range of distances. So it depends on the object and the eye only, never
  /// vanishes, and is the object's nearest point's as long as the eye is as far away from that as the
  /// object's middle is.
  /// @param middle, halfRange of the object's distances from the eye along the view, halfRange positive
  static float nearestDistance(float middle, float halfRange);

  /// |grad V . E|^k_nz for volumes, (N . E)^k_nz for surfaces: the part by slant.
  /// @param cosine of the angle between normal and eye; a negative one counts as 0
  float slantFactor(float cosine) const;
};

} // namespace ink::stipple
