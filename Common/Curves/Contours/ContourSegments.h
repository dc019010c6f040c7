// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Contours/ContourSurface.h"
#include "Curves/Contours/Contours.h"
#include "Curves/Contours/Eye.h"

#include <algorithm>
#include <cstdint>
#include <span>

namespace ink
{

/// A point of a contour on the edge between two corners, where n.v is 0; or one at a corner, if both are the
/// same. The lower one stands first, so that all faces at an edge name it alike.
struct ContourNode
{
  std::uint32_t corner0;
  std::uint32_t corner1;

  static ContourNode between(std::uint32_t a, std::uint32_t b) { return { std::min(a, b), std::max(a, b) }; }
  static ContourNode at(std::uint32_t corner) { return { corner, corner }; }
};

/// A part of a contour within a face, or on the edge between two.
struct ContourSegment
{
  ContourNode from;
  ContourNode to;
  std::uint32_t face;
  std::uint32_t otherFace; ///< the same if it lies within a face or on a border
};

/// Joins segments of one kind to chains. Points that follow each other at one position, as where n.v is
/// exactly 0 at a corner, become one, and what is left as a single point is left out.
Contours chainContours(const ContourSurface& surface, std::span<const ContourSegment> segments,
  ContourKind kind, const Eye& eye, const ContourArrays& arrays);

} // namespace ink
