#pragma once

namespace ink
{

/// Boundary enhancement (Lu et al. 2003, section 5.1 and Table 1, row 1; volumes only): more stipples where
/// the gradient is large.
struct Boundary
{
  bool on = true;
  float kgc = 0.2f; ///< what every voxel gets; not negative
  float kgs = 1.0f; ///< what the gradient's magnitude adds; not negative
  float kge = 1.0f; ///< sharpness: with a larger one, only the largest gradients count

  /// T_b = v (k_gc + k_gs |grad V|^k_ge).
  /// @param value v, normalized to 0..1
  /// @param gradientMagnitude normalized to 0..1
  float factor(float value, float gradientMagnitude) const;
};

} // namespace ink
