// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "IsoSurface/CellBricks.h"
#include "Simd/BrickView.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>

namespace ink
{

/// A face of a tetrahedron, by its corners: the lowest one, a sample, and which of that sample's neighbors
/// the others are: bits x + 2 y + 4 z of the difference, those of `middle` being some of those of `high`.
struct ContourFace
{
  static constexpr int shapes = 12;
  struct Shape
  {
    std::uint8_t middle;
    std::uint8_t high;
  };
  static constexpr std::array<Shape, shapes> shapeOf = { { { 1, 3 }, { 2, 3 }, { 2, 6 }, { 4, 6 }, { 1, 5 },
    { 4, 5 }, { 1, 7 }, { 2, 7 }, { 4, 7 }, { 3, 7 }, { 5, 7 }, { 6, 7 } } };

  /// The number of faces at the samples of a brick: face n is of the sample n / shapes and the shape
  /// n % shapes.
  static constexpr int inBrick = BrickView::size * shapes;
};

/// A segment of the contour within a brick. Seen from where values are lower, what faces the eye is on the
/// left. (Where axes are left-handed, on the right, unless the search is told that they are.)
struct BrickSegment
{
  glm::dvec3 begin; ///< in the unit cell
  std::uint16_t beginFace;
  std::uint16_t endFace;
  std::uint8_t cell; ///< bit of CellBrick
};

/// The segments of a brick; at most two a tetrahedron, and that only if rounding makes it so.
struct BrickSegments
{
  std::array<BrickSegment, 64 * 12> segments;
  int count;
};

/// The occluding contour within cells, without a surface mesh (Burns et al. 2005, section 2.2: on each face,
/// where the zero sets of f - iso and grad f . v intersect). They march through the cell's own faces, where
/// the zero sets of bilinear functions may intersect several times; here the cell is six tetrahedra around
/// its diagonal from corner 0 to corner 7 (Kuhn 1960), in which both functions are linear, as marching
/// tetrahedra do: then a contour passes a face once at most, cells on both sides of a face make the same node
/// of it, bitwise, and each node has at most one segment that ends and one that begins there.
///
/// @param cells those of the brick to search, whose corners `view` knows; they all hold the surface
/// @param mirrored the grid's axes are left-handed
void findBrickContour(const BrickView& view, std::uint64_t cells, bool mirrored, BrickSegments& found);

/// The node of a face that the contour passes, as findBrickContour has it, from the face's lowest corner.
/// @param shape of ContourFace
/// @param offsets, facing as in BrickView, of the lowest, middle and highest corner
glm::dvec3 contourNode(int shape, const std::array<double, 3>& offsets, const std::array<double, 3>& facing);

} // namespace ink
