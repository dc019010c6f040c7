#pragma once

namespace ink
{

/// Resolution enhancement (Lu et al. 2003, section 5.2 and Table 1, row 3): as many stipples as an element's
/// projection has room for, so that the pattern is as dense far away as close by.
struct Resolution
{
  bool on = true;
  float krc = -2.0f; ///< not positive, so that the factor is subtractive; -2: as perspective shrinks areas
  float knz = 1.0f;  ///< 1: as slanted areas appear smaller; 0: whatever the slant; not negative

  /// ((D_near + d_i) / (D_near + d_0))^k_rc, the part by distance.
  /// @param distance D_near + d_i: the element's distance from the eye along the view
  /// @param nearest D_near + d_0: the object's nearest point's
  float distanceFactor(float distance, float nearest) const;

  /// |grad V . E|^k_nz for volumes, (N . E)^k_nz for surfaces: the part by slant.
  /// @param cosine of the angle between normal and eye; a negative one counts as 0
  float slantFactor(float cosine) const;
};

} // namespace ink
