#pragma once

namespace ink
{

/// Distance enhancement (Lu et al. 2003, section 5.3 and Table 1, row 4): more and larger stipples in front.
struct Distance
{
  bool on = true;
  float kde = 1.0f;  ///< with a larger one, only the nearest and the farthest parts change; positive
  float size = 0.5f; ///< 0: stipples keep their diameter; 1: it changes as their number does

  /// T_d = 1 + (z / a)^k_de, the power with the sign of z: 0 at the far end, 1 in the middle, 2 at the near
  /// end.
  /// @param depth z / a, -1 at the object's far end to 1 at its near end
  float factor(float depth) const;

  /// What the diameter is multiplied by: 1 + size (T_d - 1).
  float sizeFactor(float depth) const;
};

} // namespace ink
