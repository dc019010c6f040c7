// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/BrickContour.h"

#include "Curves/Contours/BrickSamples.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace ink
{
namespace
{

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

/// The edge between two corners of a cell, the first of them the lower one.
struct Edge
{
  std::uint8_t low;
  std::uint8_t high;
};

/// A side of the polygon in which the surface intersects a tetrahedron, which lies on one of its faces. Its
/// ends are two of the polygon's corners, in the order of their edges, so that both tetrahedra at the face
/// have the same.
struct PolygonSide
{
  std::array<std::uint8_t, 2> ends;
  std::array<Edge, 2> edges;
  std::uint16_t face; ///< as in BrickSegment, if the cell were the brick's first
};

/// That polygon, counterclockwise as seen from where values are lower: side n leads from corner n to the
/// next. Corners of the cell are indices of samples in its brick, from corner 0.
struct SurfacePolygon
{
  int count = 0; ///< of its corners; a triangle's first one stands again where the fourth would be
  std::array<std::uint8_t, 4> low{};
  std::array<std::uint8_t, 4> high{};
  std::array<PolygonSide, 4> sides{};
};

constexpr std::uint8_t sampleOf(int corner)
{
  return static_cast<std::uint8_t>(
    (corner & 1) + BrickView::rowSize * (corner >> 1 & 1) + BrickView::layerSize * (corner >> 2));
}

constexpr PolygonSide sideBetween(const std::array<Edge, 4>& edges, std::uint8_t one, std::uint8_t other)
{
  PolygonSide side{ { one, other }, { edges[one], edges[other] }, 0 };
  auto& [a, b] = side.edges;
  if (b.low < a.low || (b.low == a.low && b.high < a.high))
  {
    side = { { other, one }, { edges[other], edges[one] }, 0 };
  }
  // Two of the four ends are the same corner; corners of a tetrahedron are nested, so their numbers ascend.
  const int first = std::min(a.low, b.low);
  const int last = std::max(a.high, b.high);
  const int middle = a.high != last ? a.high : b.high != last ? b.high : a.low != first ? a.low : b.low;
  for (int shape = 0; shape < ContourFace::shapes; ++shape)
  {
    if (ContourFace::shapeOf[shape].middle == middle - first &&
      ContourFace::shapeOf[shape].high == last - first)
    {
      side.face = static_cast<std::uint16_t>(sampleOf(first) * ContourFace::shapes + shape);
    }
  }
  return side;
}

/// @param inside bit c: the tetrahedron's corner c is inside the surface
constexpr SurfacePolygon polygonOf(const std::array<std::uint8_t, 4>& corners, bool rightHanded, int inside)
{
  SurfacePolygon polygon;
  std::array<Edge, 4> edges{};
  const auto add = [&](int a, int b)
  {
    const std::uint8_t first = corners[a];
    const std::uint8_t second = corners[b];
    edges[polygon.count++] = first < second ? Edge{ first, second } : Edge{ second, first };
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
      const Edge edge = edges[n];
      edges[n] = edges[polygon.count - 1 - n];
      edges[polygon.count - 1 - n] = edge;
    }
  }
  for (int n = 0; n < 4 && polygon.count != 0; ++n)
  {
    const int corner = n % polygon.count;
    polygon.low[n] = sampleOf(edges[corner].low);
    polygon.high[n] = sampleOf(edges[corner].high);
    polygon.sides[n] = sideBetween(
      edges, static_cast<std::uint8_t>(corner), static_cast<std::uint8_t>((corner + 1) % polygon.count));
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

/// Of a set of a cell's corners (bit c: corner c), which tetrahedra have corners inside and outside of it,
/// and which of its corners each of them has in it.
struct CornerSet
{
  std::uint8_t mixed = 0;
  std::array<std::uint8_t, Tetrahedra> inside{};
};
constexpr std::array<CornerSet, 256> makeCornerSets()
{
  std::array<CornerSet, 256> sets;
  for (int corners = 0; corners < 256; ++corners)
  {
    for (int t = 0; t < Tetrahedra; ++t)
    {
      int inside = 0;
      for (int n = 0; n < 4; ++n)
      {
        inside |= (corners >> TetrahedronCorners[t][n] & 1) << n;
      }
      sets[corners].inside[t] = static_cast<std::uint8_t>(inside);
      sets[corners].mixed |= static_cast<std::uint8_t>((inside != 0 && inside != 15) << t);
    }
  }
  return sets;
}
constexpr std::array<CornerSet, 256> CornerSets = makeCornerSets();

/// The sides of a polygon that are passed, for which of its corners face the eye (bit n: corner n): from
/// where a walk around leaves what does to where it comes back.
struct Passage
{
  int count = 0;
  std::array<std::array<std::uint8_t, 2>, 2> sides{};
};
constexpr Passage passageOf(int corners, int faces)
{
  Passage passage;
  const auto facesEye = [&](int n) { return (faces >> n % corners & 1) != 0; };
  for (int n = 0; n < corners; ++n)
  {
    if (facesEye(n) && !facesEye(n + 1))
    {
      int back = n + 1;
      while (!facesEye(back + 1))
      {
        ++back;
      }
      passage.sides[passage.count++] = { static_cast<std::uint8_t>(n),
        static_cast<std::uint8_t>(back % corners) };
    }
  }
  return passage;
}
constexpr std::array<std::array<Passage, 16>, 2> makePassages()
{
  std::array<std::array<Passage, 16>, 2> passages;
  for (int faces = 0; faces < 16; ++faces)
  {
    passages[0][faces] = passageOf(3, faces & 7);
    passages[1][faces] = passageOf(4, faces);
  }
  return passages;
}
/// Of triangles, whose fourth bit does not count, and of quadrangles.
constexpr std::array<std::array<Passage, 16>, 2> Passages = makePassages();

/// Where the surface intersects an edge, and n . v there.
struct Intersection
{
  double share; ///< of the edge, from its low end
  double facing;
};

Intersection intersect(double lowOffset, double highOffset, double lowFacing, double highFacing)
{
  const double low = std::abs(lowOffset);
  const double high = std::abs(highOffset);
  const double share = low / (low + high);
  return { share, (1.0 - share) * lowFacing + share * highFacing };
}

constexpr std::array<std::array<double, 3>, 8> CornerPositions{ { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 },
  { 0.0, 1.0, 0.0 }, { 1.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 }, { 1.0, 0.0, 1.0 }, { 0.0, 1.0, 1.0 },
  { 1.0, 1.0, 1.0 } } };

glm::dvec3 positionAt(const Edge& edge, double share)
{
  const auto& low = CornerPositions[edge.low];
  const auto& along = CornerPositions[edge.high ^ edge.low]; // one's bits are some of the other's
  return { low[0] + share * along[0], low[1] + share * along[1], low[2] + share * along[2] };
}

/// The node between two intersections, in the order of their edges.
glm::dvec3 nodeBetween(const std::array<Edge, 2>& edges, const Intersection& onA, const Intersection& onB)
{
  const double facingA = std::abs(onA.facing);
  const double facingB = std::abs(onB.facing);
  const glm::dvec3 from = positionAt(edges[0], onA.share);
  return from + facingA / (facingA + facingB) * (positionAt(edges[1], onB.share) - from);
}

} // namespace

void findBrickContour(const BrickView& view, std::uint64_t cells, bool mirrored, BrickSegments& found)
{
  // Tetrahedra that the contour passes.
  struct Passed
  {
    std::array<Intersection, 4> corners;
    const SurfacePolygon* polygon;
    const Passage* passage;
    int first;
    int cell;
  };
  std::array<Passed, 64 * Tetrahedra + 1> passed;
  int count = 0;
  for (std::uint64_t left = cells & mixedCells(view.front); left != 0; left &= left - 1)
  {
    const int bit = std::countr_zero(left);
    const glm::ivec3 cell = CellBrick::cell(bit);
    const int first = BrickSamples::indexOf(cell);
    const double* const offsets = view.offsets + first;
    const double* const facing = view.facing + first;
    const CornerSet& inside = CornerSets[cornersOf(view.inside, cell)];
    // Between corners that all face the eye, or all do not, so does the surface.
    for (unsigned some = inside.mixed & CornerSets[cornersOf(view.front, cell)].mixed; some != 0;
         some &= some - 1)
    {
      const int t = std::countr_zero(some);
      const SurfacePolygon& polygon = Polygons[t][inside.inside[t]];
      // Always written and sometimes kept: a branch would be guessed wrong too often.
      Passed& maybe = passed[count];
      int faces = 0; // the eye: bit n for corner n
      for (int n = 0; n < 4; ++n)
      {
        const std::uint8_t low = polygon.low[n];
        const std::uint8_t high = polygon.high[n];
        maybe.corners[n] = intersect(offsets[low], offsets[high], facing[low], facing[high]);
        faces |= (maybe.corners[n].facing >= 0.0) << n;
      }
      maybe.polygon = &polygon;
      maybe.passage = &Passages[polygon.count == 4][faces];
      maybe.first = first;
      maybe.cell = bit;
      count += maybe.passage->count != 0;
    }
  }
  found.count = 0;
  for (int i = 0; i < count; ++i)
  {
    const auto& [corners, polygon, passage, first, cell] = passed[i];
    for (int n = 0; n < passage->count; ++n)
    {
      const PolygonSide& begin = polygon->sides[passage->sides[n][mirrored]];
      const PolygonSide& end = polygon->sides[passage->sides[n][!mirrored]];
      found.segments[found.count++] = { nodeBetween(
                                          begin.edges, corners[begin.ends[0]], corners[begin.ends[1]]),
        static_cast<std::uint16_t>(begin.face + first * ContourFace::shapes),
        static_cast<std::uint16_t>(end.face + first * ContourFace::shapes), static_cast<std::uint8_t>(cell) };
    }
  }
}

glm::dvec3 contourNode(int shape, const std::array<double, 3>& offsets, const std::array<double, 3>& facing)
{
  const auto [middle, high] = ContourFace::shapeOf[shape];
  const std::array<std::uint8_t, 3> corners = { 0, middle, high };
  std::array<Edge, 2> edges{};
  std::array<Intersection, 2> intersections{};
  int count = 0;
  for (const auto& [low, top] : { std::array{ 0, 1 }, std::array{ 0, 2 }, std::array{ 1, 2 } })
  {
    if ((offsets[low] >= 0.0) != (offsets[top] >= 0.0))
    {
      edges[count] = { corners[low], corners[top] };
      intersections[count++] = intersect(offsets[low], offsets[top], facing[low], facing[top]);
    }
  }
  return nodeBetween(edges, intersections[0], intersections[1]);
}

} // namespace ink
