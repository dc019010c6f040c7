// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/GridBorder.h"

#include "Core/MortonOrder.h"
#include "Curves/ChainSegments.h"
#include "Curves/Contours/DescribeContours.h"
#include "IsoSurface/IsoOffset.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ink
{
namespace
{

/// Bricks by their position among all cells.
class BrickIndex
{
public:
  explicit BrickIndex(std::span<const CellBrick> bricks)
    : Bricks(bricks)
  {
  }

  bool isActive(const glm::ivec3& cell) const
  {
    if (std::min({ cell.x, cell.y, cell.z }) < 0)
    {
      return false;
    }
    const auto orderOf = [](const CellBrick& brick)
    { return mortonOf(glm::uvec3(brick.first / CellBrick::width)); };
    const std::uint64_t wanted = mortonOf(glm::uvec3(cell / CellBrick::width));
    const auto found = std::lower_bound(this->Bricks.begin(), this->Bricks.end(), wanted,
      [&](const CellBrick& brick, std::uint64_t order) { return orderOf(brick) < order; });
    return found != this->Bricks.end() && orderOf(*found) == wanted &&
      (found->cells >> bitOf(cell % CellBrick::width) & 1) != 0;
  }

  static int bitOf(const glm::ivec3& inBrick) { return inBrick.x + 4 * inBrick.y + 16 * inBrick.z; }

private:
  std::span<const CellBrick> Bricks;
};

/// Lines across faces of cells, between nodes on the edges of tetrahedra.
template <class T>
class FaceLines
{
public:
  FaceLines(const GridField<T>& field, double isoValue)
    : Samples(field)
    , Offset(isoValue)
  {
  }

  /// @param lowest corner of the face, a sample
  /// @param axis across the face
  /// @param cell that the face belongs to
  void add(const glm::ivec3& lowest, int axis, std::int64_t cell)
  {
    // Tetrahedra divide each face along its diagonal from the lowest corner to the highest.
    const unsigned first = 1u << (axis + 1) % 3;
    const unsigned second = 1u << (axis + 2) % 3;
    for (const unsigned middle : { first, second })
    {
      const std::array<unsigned, 3> corners{ 0, middle, first | second };
      std::array<bool, 3> inside{};
      for (std::size_t n = 0; n < 3; ++n)
      {
        inside[n] = this->offsetAt(lowest + stepOf(corners[n])) >= 0.0;
      }
      std::vector<std::uint64_t> nodes;
      for (std::size_t n = 0; n < 3; ++n)
      {
        const std::size_t next = (n + 1) % 3;
        if (inside[n] != inside[next])
        {
          nodes.push_back(
            this->nodeOf(lowest, std::min(corners[n], corners[next]), std::max(corners[n], corners[next])));
        }
      }
      if (!nodes.empty())
      {
        this->Ends.push_back({ nodes[0], nodes[1] });
        this->Cells.push_back(cell);
      }
    }
  }

  /// Chains with positions, kinds and elements.
  Contours join() const
  {
    std::vector<std::uint64_t> nodes;
    for (const auto& [from, to] : this->Ends)
    {
      nodes.insert(nodes.end(), { from, to });
    }
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    const auto numberOf = [&](std::uint64_t node)
    { return static_cast<std::uint32_t>(std::ranges::lower_bound(nodes, node) - nodes.begin()); };
    std::vector<Segment> segments;
    for (const auto& [from, to] : this->Ends)
    {
      segments.push_back({ numberOf(from), numberOf(to) });
    }
    const Chains chains = chainSegments(segments, nodes.size());
    Contours contours;
    contours.chains = chains.polylines;
    contours.kinds.assign(chains.polylines.size(), ContourKind::Border);
    for (std::size_t n = 0; n < chains.nodes.size(); ++n)
    {
      contours.positions.push_back(this->positionOf(nodes[chains.nodes[n]]));
      contours.elements.push_back(this->Cells[chains.segments[n]]);
    }
    return contours;
  }

private:
  static glm::ivec3 stepOf(unsigned bits) { return { bits & 1, bits >> 1 & 1, bits >> 2 }; }

  double offsetAt(const glm::ivec3& sample) const { return this->Offset(this->Samples.at(sample)); }

  /// The edge between two neighbors of a sample, by its lower end and which of that one's neighbors the other
  /// is.
  std::uint64_t nodeOf(const glm::ivec3& lowest, unsigned low, unsigned high) const
  {
    return this->Samples.geometry().offset(lowest + stepOf(low)) << 3 | (high ^ low);
  }

  glm::dvec3 positionOf(std::uint64_t node) const
  {
    const GridGeometry& geometry = this->Samples.geometry();
    const glm::u64vec3 n(geometry.dimensions());
    const std::uint64_t offset = node >> 3;
    const glm::ivec3 low(offset % n.x, offset / n.x % n.y, offset / (n.x * n.y));
    const glm::ivec3 step = stepOf(static_cast<unsigned>(node & 7));
    const double from = this->offsetAt(low);
    const double share = from / (from - this->offsetAt(low + step));
    return geometry.toWorld(glm::dvec3(low) + share * glm::dvec3(step));
  }

  GridField<T> Samples;
  IsoOffset<T> Offset;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> Ends;
  std::vector<std::int64_t> Cells;
};

} // namespace

template <class T>
Contours gridBorder(
  const GridField<T>& field, double isoValue, std::span<const CellBrick> bricks, const ContourArrays& arrays)
{
  const BrickIndex index(bricks);
  const glm::ivec3 cells = glm::max(field.geometry().dimensions() - 1, 0);
  FaceLines<T> lines(field, isoValue);
  for (const CellBrick& brick : bricks)
  {
    for (std::uint64_t left = brick.cells; left != 0; left &= left - 1)
    {
      const glm::ivec3 inBrick = CellBrick::cell(std::countr_zero(left));
      const glm::ivec3 cell = brick.first + inBrick;
      const std::int64_t element = cell.x + cells.x * (cell.y + static_cast<std::int64_t>(cells.y) * cell.z);
      for (int face = 0; face < 6; ++face)
      {
        const int axis = face / 2;
        const int side = face % 2;
        glm::ivec3 beside = cell;
        beside[axis] += 2 * side - 1;
        const glm::ivec3 there = beside - brick.first;
        const bool within = there[axis] >= 0 && there[axis] < CellBrick::width;
        const bool active =
          within ? (brick.cells >> BrickIndex::bitOf(there) & 1) != 0 : index.isActive(beside);
        if (!active)
        {
          glm::ivec3 lowest = cell;
          lowest[axis] += side;
          lines.add(lowest, axis, element);
        }
      }
    }
  }
  Contours border = lines.join();
  ContourArrays ofField = arrays;
  ofField.radialCurvature = false;
  describeContours(field, isoValue, Eye(), ofField, {}, border);
  border.radialCurvature.assign(arrays.radialCurvature ? border.positions.size() : 0, 0.0f);
  return border;
}

#define INK_INSTANTIATE(T)                                                                                   \
  template Contours gridBorder(const GridField<T>&, double, std::span<const CellBrick>, const ContourArrays&);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
