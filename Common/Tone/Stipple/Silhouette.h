// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ink::stipple
{

/// Silhouette enhancement (Lu et al. 2003, section 5.1 and Table 1, row 2; volumes only): more stipples where
/// the gradient is perpendicular to the view.
struct Silhouette
{
  bool on = true;
  float base = 0.3f;     ///< constant part; not negative
  float gain = 2.0f;     ///< weight of silhouettes; not negative
  float exponent = 0.5f; ///< sharpness: with smaller values silhouettes are thinner

  /// T_s = v (k_sc + k_ss (1 - |grad V . E|^k_se)), grad V and E of unit length.
  /// @param value v, normalized to 0..1
  /// @param cosine of the angle between gradient and eye; its sign does not matter
  float factor(float value, float cosine) const;
};

} // namespace ink::stipple
