// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/CellContour.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace ink
{
namespace
{

/// The edge between two corners of a cell, the first of them the lower one.
struct Edge
{
  std::uint8_t low;
  std::uint8_t high;
};

/// The polygon in which the surface intersects a tetrahedron: the edges that it intersects, counterclockwise
/// as seen from where values are lower.
struct SurfacePolygon
{
  std::array<Edge, 4> edges{};
  int count = 0;
};

/// The corners of the six tetrahedra: corner 0, plus one axis, plus another, corner 7. Every other pair of
/// axes is in cyclic order, so that the tetrahedron is right-handed.
constexpr int Tetrahedra = 6;
constexpr std::array<std::array<std::uint8_t, 4>, Tetrahedra> TetrahedronCorners{ {
  { 0, 1, 3, 7 }, { 0, 2, 6, 7 }, { 0, 4, 5, 7 }, // x y, y z, z x
  { 0, 2, 3, 7 }, { 0, 4, 6, 7 }, { 0, 1, 5, 7 }, // y x, z y, x z
} };
constexpr int RightHanded = 3;

/// Even permutations of a tetrahedron's corners that bring each corner, and each pair, to the front.
constexpr std::array<std::array<int, 4>, 4> CornerFirst{ { { 0, 1, 2, 3 }, { 1, 0, 3, 2 }, { 2, 3, 0, 1 },
  { 3, 2, 1, 0 } } };
constexpr std::array<std::array<int, 4>, 6> PairFirst{ { { 0, 1, 2, 3 }, { 0, 2, 3, 1 }, { 0, 3, 1, 2 },
  { 1, 2, 0, 3 }, { 1, 3, 2, 0 }, { 2, 3, 0, 1 } } };

/// @param inside bit c: the tetrahedron's corner c is inside the surface
constexpr SurfacePolygon polygonOf(const std::array<std::uint8_t, 4>& corners, bool rightHanded, int inside)
{
  SurfacePolygon polygon;
  const auto add = [&](int a, int b)
  {
    const std::uint8_t first = corners[a];
    const std::uint8_t second = corners[b];
    polygon.edges[polygon.count++] = first < second ? Edge{ first, second } : Edge{ second, first };
  };
  bool outward = rightHanded;
  for (const auto& [i, j, k, l] : CornerFirst)
  {
    // Seen from the side without i, the edges to j, k and l are counterclockwise.
    if (inside == 1 << i || inside == (15 ^ 1 << i))
    {
      add(i, j);
      add(i, k);
      add(i, l);
      outward = (inside == 1 << i) == rightHanded;
    }
  }
  for (const auto& [i, j, k, l] : PairFirst)
  {
    if (inside == (1 << i | 1 << j))
    {
      add(i, k);
      add(i, l);
      add(j, l);
      add(j, k);
    }
  }
  if (!outward)
  {
    for (int n = 0; n < polygon.count / 2; ++n)
    {
      const Edge edge = polygon.edges[n];
      polygon.edges[n] = polygon.edges[polygon.count - 1 - n];
      polygon.edges[polygon.count - 1 - n] = edge;
    }
  }
  return polygon;
}

constexpr std::array<std::array<SurfacePolygon, 16>, Tetrahedra> makePolygons()
{
  std::array<std::array<SurfacePolygon, 16>, Tetrahedra> polygons;
  for (int t = 0; t < Tetrahedra; ++t)
  {
    for (int inside = 0; inside < 16; ++inside)
    {
      polygons[t][inside] = polygonOf(TetrahedronCorners[t], t < RightHanded, inside);
    }
  }
  return polygons;
}

constexpr std::array<std::array<SurfacePolygon, 16>, Tetrahedra> Polygons = makePolygons();

/// Of each set of a cell's corners (bit c: corner c), the tetrahedra that have corners inside and outside of
/// it.
constexpr std::array<std::uint8_t, 256> makeMixed()
{
  std::array<std::uint8_t, 256> mixed{};
  for (int corners = 0; corners < 256; ++corners)
  {
    for (int t = 0; t < Tetrahedra; ++t)
    {
      int in = 0;
      for (const std::uint8_t corner : TetrahedronCorners[t])
      {
        in += corners >> corner & 1;
      }
      mixed[corners] |= static_cast<std::uint8_t>((in % 4 != 0) << t);
    }
  }
  return mixed;
}
constexpr std::array<std::uint8_t, 256> MixedTetrahedra = makeMixed();

/// Where the surface intersects an edge, and n . v there.
struct Intersection
{
  double share; ///< of the edge, from its low end
  double facing;
};

Intersection intersect(const CellCorners& cell, const Edge& edge)
{
  const double low = std::abs(cell.offsets[edge.low]);
  const double high = std::abs(cell.offsets[edge.high]);
  const double share = low / (low + high);
  return { share, (1.0 - share) * cell.facing[edge.low] + share * cell.facing[edge.high] };
}

glm::dvec3 cornerPosition(int corner)
{
  return { corner & 1, corner >> 1 & 1, corner >> 2 };
}

glm::dvec3 positionAt(const Edge& edge, double share)
{
  const glm::dvec3 low = cornerPosition(edge.low);
  return low + share * (cornerPosition(edge.high) - low);
}

/// An edge of a tetrahedron that the surface intersects.
struct IntersectedEdge
{
  Edge edge;
  Intersection at;
};

/// The node on the face that two edges of a tetrahedron share. The same for any order of the two.
CellContourNode nodeBetween(const IntersectedEdge& one, const IntersectedEdge& other)
{
  const bool inOrder =
    one.edge.low < other.edge.low || (one.edge.low == other.edge.low && one.edge.high < other.edge.high);
  const auto& [a, onA] = inOrder ? one : other;
  const auto& [b, onB] = inOrder ? other : one;
  CellContourNode node;
  // Two of the four ends are the same corner; corners of a tetrahedron are nested, so their numbers ascend.
  const std::uint8_t first = std::min(a.low, b.low);
  const std::uint8_t last = std::max(a.high, b.high);
  const std::uint8_t middle = a.high != last ? a.high
    : b.high != last                         ? b.high
    : a.low != first                         ? a.low
                                             : b.low;
  node.corners = { first, middle, last };
  const double facingA = std::abs(onA.facing);
  const double facingB = std::abs(onB.facing);
  const glm::dvec3 from = positionAt(a, onA.share);
  node.position = from + facingA / (facingA + facingB) * (positionAt(b, onB.share) - from);
  return node;
}

} // namespace

CellContour findCellContour(const CellCorners& cell)
{
  CellContour contour;
  int insideCell = 0;
  int frontCell = 0;
  for (int corner = 0; corner < 8; ++corner)
  {
    insideCell |= (cell.offsets[corner] >= 0.0) << corner;
    frontCell |= (cell.facing[corner] >= 0.0) << corner;
  }
  // Between corners that all face the eye, or all do not, so does the surface.
  for (unsigned left = MixedTetrahedra[insideCell] & MixedTetrahedra[frontCell]; left != 0; left &= left - 1)
  {
    const int t = std::countr_zero(left);
    int inside = 0;
    for (int n = 0; n < 4; ++n)
    {
      inside |= (insideCell >> TetrahedronCorners[t][n] & 1) << n;
    }
    const SurfacePolygon& polygon = Polygons[t][inside];
    std::array<IntersectedEdge, 4> edges;
    int faces = 0; // the eye: bit n for edge n
    for (int n = 0; n < polygon.count; ++n)
    {
      edges[n] = { polygon.edges[n], intersect(cell, polygon.edges[n]) };
      faces |= (edges[n].at.facing >= 0.0) << n;
    }
    if (faces == 0 || faces == (1 << polygon.count) - 1)
    {
      continue;
    }
    // From where a walk around the polygon leaves what faces the eye to where it comes back.
    const auto nodeAfter = [&](int n) { return nodeBetween(edges[n], edges[(n + 1) % polygon.count]); };
    const auto facesEye = [&](int n) { return (faces >> n % polygon.count & 1) != 0; };
    for (int n = 0; n < polygon.count; ++n)
    {
      if (facesEye(n) && !facesEye(n + 1))
      {
        int back = n + 1;
        while (!facesEye(back + 1))
        {
          ++back;
        }
        contour.segments[contour.count++] = { nodeAfter(n), nodeAfter(back % polygon.count) };
      }
    }
  }
  return contour;
}

} // namespace ink
