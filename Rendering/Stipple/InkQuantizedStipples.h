// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkQuantizedStipples_h
#define InkQuantizedStipples_h

#include "InkStipplePoints.h"

#include "Stippling/QuantizedPosition.h"

#include <cstdint>
#include <vector>

/// Stipples in half the memory: where they lie in their elements' boxes, in ten bits an axis.
struct InkQuantizedStipples
{
  /// 8 bytes a stipple.
  struct Vertex
  {
    std::uint32_t Position; ///< in the element's box, as ink::stipple::quantizePosition makes it
    std::uint32_t ElementAndRank;
  };
  static_assert(sizeof(Vertex) == 8);
  static_assert(sizeof(ink::stipple::QuantizationBox) == 16);

  explicit InkQuantizedStipples(const InkStipplePoints& points);

  std::vector<Vertex> Vertices;                     ///< in the points' order
  std::vector<ink::stipple::QuantizationBox> Boxes; ///< of the elements, in the local frame
  glm::vec3 Edges{ 0.0f };                          ///< of the boxes at scale 1
};

#endif
