// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ink::stipple
{

/// Distance enhancement (Lu et al. 2003, section 5.3 and Table 1, row 4): more and larger stipples in front.
struct Distance
{
  bool on = true;
  float exponent = 1.0f; ///< with larger values only the nearest and farthest parts change; positive
  float size = 0.5f;     ///< 0: stipples keep their diameter; 1: it changes as their number does

  /// T_d = 1 + (z / a)^k_de, the power with the sign of z: 0 at the far end, 1 in the middle, 2 at the near
  /// end.
  /// @param depth z / a, -1 at the object's far end to 1 at its near end
  float factor(float depth) const;

  /// The factor on the diameter: 1 + size (T_d - 1).
  float sizeFactor(float depth) const;
};

} // namespace ink::stipple
