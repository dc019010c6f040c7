// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>

namespace ink
{

/// What the contour in one cell of a grid is made of, of its eight corners: corner c is x + 2 y + 4 z.
struct CellCorners
{
  std::array<double, 8> offsets; ///< field value minus iso-value; inside the surface not negative
  std::array<double, 8> facing;  ///< n . v, of any scale: a part of the surface faces the eye if not negative
};

/// Where the contour passes a face of a tetrahedron.
struct CellContourNode
{
  /// The face's corners a, b and c of the cell, each of whose coordinates is at least that of the one before.
  std::array<std::uint8_t, 3> corners;
  glm::dvec3 position; ///< in the unit cell
};

/// The contour's segments in one cell.
struct CellContour
{
  /// At most two a tetrahedron, and that only if rounding makes it so.
  std::array<std::array<CellContourNode, 2>, 12> segments;
  int count = 0;
};

/// The occluding contour within a cell, without a surface mesh (Burns et al. 2005, section 2.2: on each face,
/// where the zero sets of f - iso and grad f . v intersect). They march through the cell's own faces, where
/// the zero sets of bilinear functions may intersect several times; here the cell is six tetrahedra around
/// its diagonal from corner 0 to corner 7 (Kuhn 1960), in which both functions are linear, as marching
/// tetrahedra do: then a contour passes a face once at most, cells on both sides of a face make the same node
/// of it, bitwise, and each node has at most one segment that ends and one that begins there.
///
/// Segments are directed: seen from where values are lower, what faces the eye is on the left. (In a cell
/// whose axes are left-handed, on the right.)
CellContour findCellContour(const CellCorners& cell);

} // namespace ink
