// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/GridContours.h"

#include "Core/KeyNumbers.h"
#include "Core/ParallelFor.h"
#include "Curves/ChainSegments.h"
#include "Curves/Contours/CellContour.h"
#include "Curves/Contours/DescribeContours.h"
#include "Fields/ScalarDifference.h"
#include "IsoSurface/IsoOffset.h"
#include "IsoSurface/IsoSurfaceSamples.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <numeric>
#include <span>

namespace ink
{
namespace
{

/// Bricks that a thread searches at a time.
constexpr std::size_t BricksAtOnce = 16;

/// The eye in steps of the whole grid. There v is a vector and grad f a covector, so that grad f . v is the
/// same number as in the world.
Eye eyeInSteps(const GridGeometry& geometry, const Eye& eye)
{
  return eye.parallel ? Eye::along(glm::inverse(geometry.stepToWorld()) * eye.direction)
                      : Eye::at(geometry.toGlobalIndex(eye.position));
}

glm::ivec3 cornerOf(int corner)
{
  return { corner & 1, corner >> 1 & 1, corner >> 2 };
}

/// A set of the 5 x 5 x 5 samples at the corners of a brick's cells: bit x + 5 y of a layer stands for a
/// sample.
class BrickSamples
{
public:
  static constexpr int width = CellBrick::width + 1;
  static constexpr int count = width * width * width;

  BrickSamples() = default;
  /// The corners of cells.
  explicit BrickSamples(std::uint64_t cells)
  {
    for (int z = 0; z < CellBrick::width; ++z)
    {
      std::uint32_t corners = 0;
      for (int y = 0; y < CellBrick::width; ++y)
      {
        const std::uint32_t row = cells >> (16 * z + 4 * y) & 15;
        corners |= (row | row << 1) << width * y | (row | row << 1) << width * (y + 1);
      }
      this->Layers[z] |= corners;
      this->Layers[z + 1] |= corners;
    }
  }

  void add(const glm::ivec3& inBrick) { this->Layers[inBrick.z] |= 1u << (inBrick.x + width * inBrick.y); }

  /// The cells that have corners in the set as well as outside.
  std::uint64_t mixedCells() const
  {
    std::uint64_t cells = 0;
    for (int z = 0; z < CellBrick::width; ++z)
    {
      const std::uint32_t low = this->Layers[z];
      const std::uint32_t high = this->Layers[z + 1];
      const auto shifted = [](std::uint32_t layer, auto join)
      { return join(join(layer, layer >> 1), join(layer >> width, layer >> (width + 1))); };
      const std::uint32_t all = shifted(low & high, std::bit_and<>());
      const std::uint32_t any = shifted(low | high, std::bit_or<>());
      const std::uint64_t mixed = any & ~all;
      for (int y = 0; y < CellBrick::width; ++y)
      {
        cells |= (mixed >> width * y & 15) << (16 * z + 4 * y);
      }
    }
    return cells;
  }

  static int indexOf(const glm::ivec3& inBrick)
  {
    return inBrick.x + width * (inBrick.y + width * inBrick.z);
  }

  /// Calls visit(index, sample in the brick) for each, in order.
  template <class Visit>
  void forEach(const Visit& visit) const
  {
    for (int z = 0; z < width; ++z)
    {
      for (std::uint32_t left = this->Layers[z]; left != 0; left &= left - 1)
      {
        const int bit = std::countr_zero(left);
        visit(bit + width * width * z, glm::ivec3(columnOf[bit], rowOf[bit], z));
      }
    }
  }

private:
  // Of a sample's bit in a layer.
  static constexpr std::array<std::uint8_t, 25> columnOf = { 0, 1, 2, 3, 4, 0, 1, 2, 3, 4, 0, 1, 2, 3, 4, 0,
    1, 2, 3, 4, 0, 1, 2, 3, 4 };
  static constexpr std::array<std::uint8_t, 25> rowOf = { 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 3, 3,
    3, 3, 3, 4, 4, 4, 4, 4 };

  std::array<std::uint32_t, width> Layers{};
};

/// The direction of a vector of any length; zero or NaN where it has none.
glm::dvec3 directionOf(const glm::dvec3& vector)
{
  const glm::dvec3 size = glm::abs(vector);
  const double scale = std::max({ size.x, size.y, size.z });
  return scale > 0.0 ? glm::normalize(vector / scale) : glm::dvec3(0.0);
}

/// Of the contour within a cell, directed as in CellContour. Positions are in steps of the whole grid.
struct GridSegment
{
  std::array<std::uint64_t, 2> nodes;
  std::array<glm::dvec3, 2> positions;
  std::int64_t cell;
};

/// Finds the segments in the bricks of one field for one eye.
template <class T>
class BrickSearch
{
public:
  BrickSearch(const GridField<T>& field, double isoValue, const Eye& eye)
    : Samples(field)
    , Offset(isoValue)
    , InSteps(eyeInSteps(field.geometry(), eye))
    // Otherwise left would be right.
    , Mirrored(glm::determinant(field.geometry().stepToWorld()) < 0.0)
  {
  }

  void find(const CellBrick& brick, std::vector<GridSegment>& segments) const
  {
    std::array<double, BrickSamples::count> facing;
    BrickSamples front;
    // The vector to the eye, an axis at a time.
    std::array<glm::dvec3, BrickSamples::width> view;
    for (int n = 0; n < BrickSamples::width; ++n)
    {
      view[n] = this->InSteps.from(glm::dvec3(this->Samples.geometry().first() + brick.first + n));
    }
    const bool inner = this->Samples.hidden().empty() && this->Samples.isInner(brick.first) &&
      this->Samples.isInner(brick.first + CellBrick::width);
    const auto lookAt = [&](const auto& gradientAt)
    {
      BrickSamples(brick.cells)
        .forEach(
          [&](int index, const glm::ivec3& inBrick)
          {
            facing[index] = -glm::dot(
              gradientAt(inBrick), glm::dvec3(view[inBrick.x].x, view[inBrick.y].y, view[inBrick.z].z));
            if (facing[index] >= 0.0)
            {
              front.add(inBrick);
            }
          });
    };
    const auto anywhere = [&](const glm::ivec3& inBrick)
    { return this->Samples.gradientAt(brick.first + inBrick); };
    if (inner)
    {
      const glm::ivec3& n = this->Samples.geometry().dimensions();
      const T* const values =
        this->Samples.data() + this->Samples.geometry().offset(brick.first) * this->Samples.stride();
      lookAt(
        [&](const glm::ivec3& inBrick)
        {
          const std::ptrdiff_t offset =
            inBrick.x + n.x * (inBrick.y + static_cast<std::ptrdiff_t>(n.y) * inBrick.z);
          const glm::dvec3 gradient = this->Samples.gradientOfInner(
            values + offset * static_cast<std::ptrdiff_t>(this->Samples.stride()));
          return GridField<T>::isComplete(gradient) ? gradient : anywhere(inBrick);
        });
    }
    else
    {
      lookAt(anywhere);
    }
    for (std::uint64_t left = brick.cells & front.mixedCells(); left != 0; left &= left - 1)
    {
      const glm::ivec3 cell = CellBrick::cell(std::countr_zero(left));
      CellCorners corners;
      for (int corner = 0; corner < 8; ++corner)
      {
        const glm::ivec3 inBrick = cell + cornerOf(corner);
        corners.offsets[corner] = this->Offset(this->Samples.at(brick.first + inBrick));
        corners.facing[corner] = facing[BrickSamples::indexOf(inBrick)];
      }
      this->addSegments(corners, brick.first + cell, segments);
    }
  }

  /// Asks for the values around a brick to be in the cache soon.
  void prefetch(const CellBrick& brick) const
  {
    const glm::ivec3& n = this->Samples.geometry().dimensions();
    for (int z = -1; z <= CellBrick::width + 1; ++z)
    {
      for (int y = -1; y <= CellBrick::width + 1; ++y)
      {
        const glm::ivec3 sample = glm::clamp(brick.first + glm::ivec3(0, y, z), glm::ivec3(0), n - 1);
        __builtin_prefetch(
          this->Samples.data() + this->Samples.geometry().offset(sample) * this->Samples.stride());
      }
    }
  }

private:
  /// The lowest corner's sample, and for the other two which of its seven neighbors they are.
  std::uint64_t idOf(const CellContourNode& node, const glm::ivec3& cell) const
  {
    const auto [a, b, c] = node.corners;
    const std::uint64_t sample = this->Samples.geometry().offset(cell + cornerOf(a));
    return sample << 6 | static_cast<std::uint64_t>(b - a) << 3 | static_cast<std::uint64_t>(c - a);
  }

  void addSegments(
    const CellCorners& corners, const glm::ivec3& cell, std::vector<GridSegment>& segments) const
  {
    const CellContour contour = findCellContour(corners);
    const glm::dvec3 first(this->Samples.geometry().first() + cell);
    const glm::ivec3 cells = this->Samples.geometry().dimensions() - 1;
    const std::int64_t index = cell.x + cells.x * (cell.y + static_cast<std::int64_t>(cells.y) * cell.z);
    for (int n = 0; n < contour.count; ++n)
    {
      const CellContourNode& from = contour.segments[n][this->Mirrored];
      const CellContourNode& to = contour.segments[n][!this->Mirrored];
      segments.push_back({ { this->idOf(from, cell), this->idOf(to, cell) },
        { first + from.position, first + to.position }, index });
    }
  }

  GridField<T> Samples;
  IsoOffset<T> Offset;
  Eye InSteps;
  bool Mirrored;
};

/// Chains of the segments, with positions in the world and cells.
/// @param parts of the segments, in order
Contours chain(const GridGeometry& geometry, std::span<const std::vector<GridSegment>> parts)
{
  const std::size_t count = std::accumulate(parts.begin(), parts.end(), std::size_t(0),
    [](std::size_t sum, const std::vector<GridSegment>& part) { return sum + part.size(); });
  KeyNumbers numbers(2 * count);
  std::vector<Segment> ends;
  std::vector<std::int64_t> cells;
  std::vector<glm::dvec3> positions; // of nodes
  ends.reserve(count);
  cells.reserve(count);
  positions.reserve(2 * count);
  for (const std::vector<GridSegment>& part : parts)
  {
    for (const GridSegment& segment : part)
    {
      Segment& numbered = ends.emplace_back();
      for (const std::size_t end : { 0, 1 })
      {
        numbered[end] = numbers.numberOf(segment.nodes[end]);
        if (numbered[end] == positions.size())
        {
          positions.push_back(segment.positions[end]);
        }
      }
      cells.push_back(segment.cell);
    }
  }
  const Chains chains = chainSegments(ends, positions.size());
  Contours contours;
  contours.chains = chains.polylines;
  contours.kinds.assign(chains.polylines.size(), ContourKind::Silhouette);
  contours.positions.reserve(chains.nodes.size());
  contours.elements.reserve(chains.nodes.size());
  for (std::size_t point = 0; point < chains.nodes.size(); ++point)
  {
    contours.positions.push_back(
      geometry.toWorld(positions[chains.nodes[point]] - glm::dvec3(geometry.first())));
    contours.elements.push_back(cells[chains.segments[point]]);
  }
  return contours;
}

} // namespace

template <class T>
GridContours<T>::GridContours(const GridField<T>& field, double isoValue, const CellSelection& selection,
  MinMaxBricks* ranges, const Progress& progress)
  : Samples(field)
  , IsoValue(isoValue)
{
  const std::vector<ActiveCells> cells = findActiveCells(
    field, std::span<const double>(&isoValue, 1), CrossingRule::HalfOpen, selection, progress, ranges);
  if (cells.front().count == 0)
  {
    return;
  }
  this->Bricks = collectBricks(cells.front());
  this->Normals = NormalClusters(
    this->Bricks.size(),
    [this](std::size_t begin, std::size_t end, std::vector<NormalCone::Item>& items)
    {
      for (std::size_t n = begin; n < end; ++n)
      {
        const CellBrick& brick = this->Bricks[n];
        BrickSamples(brick.cells)
          .forEach(
            [&](int, const glm::ivec3& inBrick)
            {
              const glm::ivec3 sample = brick.first + inBrick;
              items.push_back({ glm::dvec3(this->Samples.geometry().first() + sample),
                -directionOf(this->Samples.gradientAt(sample)) });
            });
      }
    },
    1);
}

template <class T>
std::size_t GridContours<T>::searchedBrickCount(const Eye& eye) const
{
  return this->Normals.straddling(eyeInSteps(this->Samples.geometry(), eye)).size();
}

template <class T>
Contours GridContours<T>::find(
  const Eye& eye, const ContourArrays& arrays, const GridContourOptions& options) const
{
  eye.check();
  const GridGeometry& geometry = this->Samples.geometry();
  std::vector<std::uint32_t> bricks;
  if (options.search == SilhouetteSearch::Exhaustive)
  {
    bricks.resize(this->Bricks.size());
    std::iota(bricks.begin(), bricks.end(), 0u);
  }
  else
  {
    bricks = this->Normals.straddling(eyeInSteps(geometry, eye));
  }
  const BrickSearch<T> search(this->Samples, this->IsoValue, eye);
  std::vector<std::vector<GridSegment>> parts((bricks.size() + BricksAtOnce - 1) / BricksAtOnce);
  parallelFor(parts.size(),
    [&](std::size_t part)
    {
      const std::size_t end = std::min(bricks.size(), (part + 1) * BricksAtOnce);
      for (std::size_t n = part * BricksAtOnce; n < end; ++n)
      {
        search.prefetch(this->Bricks[bricks[std::min(n + 2, bricks.size() - 1)]]);
        search.find(this->Bricks[bricks[n]], parts[part]);
      }
    });
  Contours contours = chain(geometry, parts);
  ContourProjection projection;
  projection.steps = options.projectionSteps;
  projection.reach = 2.0 * isoSurfaceSampleRadius(geometry);
  describeContours(this->Samples, this->IsoValue, eye, arrays, projection, contours);
  return contours;
}

#define INK_INSTANTIATE(T) template class GridContours<T>;
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)

} // namespace ink
