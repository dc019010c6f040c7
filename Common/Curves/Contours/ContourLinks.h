// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Contours/BrickContour.h"
#include "Curves/Contours/Contours.h"
#include "Fields/Grid/GridGeometry.h"
#include "IsoSurface/CellBricks.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace ink
{

/// The segments of some bricks, each with those before and after it. Within a brick they are linked by a
/// table of its faces; what is left open is for joinContour.
struct ContourLinks
{
  /// A segment among several parts: the part in the higher 32 bits, its segment in the lower ones.
  using Id = std::uint64_t;
  static constexpr Id none = ~Id(0);

  struct Segment
  {
    glm::dvec3 begin;  ///< in the world
    std::int64_t cell; ///< index among the grid's cells
    Id previous;
    Id next;
  };
  /// An end that is at the brick's border, or where no more cells are active.
  struct OpenEnd
  {
    std::uint64_t face; ///< the lowest corner's index among the grid's samples, times 16, plus the shape
    std::uint32_t segment;
  };

  /// @param part this one's number
  /// @param begins segments at faces of a brick: of ContourFace::inBrick numbers, zero before the first call
  void add(std::size_t part, const GridGeometry& geometry, const CellBrick& brick, const BrickSegments& found,
    std::span<std::uint32_t> begins);

  std::vector<Segment> segments;
  std::vector<OpenEnd> openBegins;
  std::vector<OpenEnd> openEnds;
};

/// Chains of the segments of all parts, in the order of their first segments: a closed one begins there.
/// @param nodeOf the position in the world of the node on a face as in OpenEnd, for chains that end
Contours joinContour(
  std::span<ContourLinks> parts, const std::function<glm::dvec3(std::uint64_t face)>& nodeOf);

} // namespace ink
