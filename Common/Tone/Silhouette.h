#pragma once

namespace ink
{

/// Silhouette enhancement (Lu et al. 2003, section 5.1 and Table 1, row 2; volumes only): more stipples where
/// the gradient is at right angles to the view.
struct Silhouette
{
  bool on = true;
  float ksc = 0.3f; ///< what every voxel gets; not negative
  float kss = 2.0f; ///< what silhouettes get in addition; not negative
  float kse = 0.5f; ///< sharpness: with a smaller one, silhouettes are thinner

  /// T_s = v (k_sc + k_ss (1 - |grad V . E|^k_se)), grad V and E of unit length.
  /// @param value v, normalized to 0..1
  /// @param cosine of the angle between gradient and eye; its sign does not matter
  float factor(float value, float cosine) const;
};

} // namespace ink
