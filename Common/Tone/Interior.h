#pragma once

namespace ink
{

/// Interior enhancement (Lu et al. 2003, section 5.4 and Table 1, row 5; volumes only): fewer and smaller
/// stipples where the gradient is small, so that what lies within shows through.
struct Interior
{
  bool on = true;
  float kie = 1.0f;  ///< falloff: with a larger one, more is see-through; not negative
  float size = 0.5f; ///< 0: stipples keep their diameter; 1: it changes as their number does

  /// T_i = |grad V|^k_ie.
  /// @param gradientMagnitude normalized to 0..1
  float factor(float gradientMagnitude) const;

  /// What the diameter is multiplied by: 1 + size (T_i - 1).
  float sizeFactor(float gradientMagnitude) const;
};

} // namespace ink
