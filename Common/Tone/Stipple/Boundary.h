// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ink::stipple
{

/// Boundary enhancement (Lu et al. 2003, section 5.1 and Table 1, row 1; volumes only): more stipples where
/// the gradient is large.
struct Boundary
{
  bool on = true;
  float base = 0.2f;     ///< constant part; not negative
  float gain = 1.0f;     ///< weight of the gradient magnitude; not negative
  float exponent = 1.0f; ///< sharpness: with larger values only the largest gradients count

  /// T_b = v (k_gc + k_gs |grad V|^k_ge).
  /// @param value v, normalized to 0..1
  /// @param gradientMagnitude normalized to 0..1
  float factor(float value, float gradientMagnitude) const;
};

} // namespace ink::stipple
