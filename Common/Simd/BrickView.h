// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace ink
{

/// The 5 x 5 x 5 samples at the corners of a brick's 4 x 4 x 4 cells as an eye sees the field there. Rows are
/// longer than needed, so that the kernels may write whole vectors. Plain data, as everything that crosses
/// the borders of instruction sets.
struct BrickView
{
  static constexpr int width = 5;
  static constexpr int rowSize = 8;
  static constexpr int layerSize = rowSize * width;
  static constexpr int size = layerSize * width;

  /// Of the sample x + rowSize y + layerSize z: -grad f . v, and f minus the iso-value as IsoOffset has it.
  alignas(64) double facing[size];
  alignas(64) double offsets[size];
  /// Where these are not negative: bit x + width y of layer z.
  std::uint32_t front[width];
  std::uint32_t inside[width];
};

/// A brick of samples that all have neighbors on all sides, and v.
template <class T>
struct BrickSource
{
  const T* first; ///< the first sample; the next one along x is next to it
  std::ptrdiff_t y;
  std::ptrdiff_t z;
  /// An offset is value * scale - iso.
  double scale;
  double iso;
  /// The vector to the eye: its x by the sample's x, and so on.
  double view[3][BrickView::rowSize];
  /// The samples to look at: bits as in BrickView.
  std::uint32_t needed[BrickView::width];
};

} // namespace ink
