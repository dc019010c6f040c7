// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ink::stipple
{

/// Interior enhancement (Lu et al. 2003, section 5.4 and Table 1, row 5; volumes only): fewer and smaller
/// stipples where the gradient is small, so that the interior shows through.
struct Interior
{
  bool on = true;
  float exponent = 1.0f; ///< falloff: with larger values more is see-through; not negative
  float size = 0.5f;     ///< 0: stipples keep their diameter; 1: it changes as their number does

  /// T_i = |grad V|^k_ie.
  /// @param gradientMagnitude normalized to 0..1
  float factor(float gradientMagnitude) const;

  /// The factor on the diameter: 1 + size (T_i - 1).
  float sizeFactor(float gradientMagnitude) const;
};

} // namespace ink::stipple
