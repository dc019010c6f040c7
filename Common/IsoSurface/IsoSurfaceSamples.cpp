// SPDX-License-Identifier: BSD-3-Clause
#include "IsoSurface/IsoSurfaceSamples.h"

#include "Core/ParallelFor.h"
#include "Fields/Grid/GridField.h"
#include "Fields/ScalarDifference.h"
#include "IsoSurface/CellPlacement.h"
#include "IsoSurface/OrderedSlabWriter.h"
#include "IsoSurface/SampleWriter.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace ink
{
namespace
{

template <class Work, class T>
bool placeAll(const GridField<T>& field, double isoValue, const SampleOptions& options,
  const ActiveCells& cells, const SampleRoom& to, const Progress& progress)
{
  const CellPlacement<T, Work> placer(field, isoValue, options);
  const auto placeSlab = [&](std::size_t s)
  { placer.place(cells.slabs[s].runs, roomAfter(to, cells.slabs[s].before)); };
  return parallelFor(cells.slabs.size(), placeSlab, progress);
}

template <class Work, class T>
bool sampleOne(const GridField<T>& field, double isoValue, const SampleOptions& options,
  const CellSelection& selection, MinMaxBricks* ranges, const GrowRoom& grow, std::size_t expected,
  std::vector<std::size_t>& counts, const Progress& progress)
{
  ActiveCells cells;
  OrderedSlabWriter<T, Work> samples(field, isoValue, options, cells, grow(expected));
  if (!findActiveCellsBySlab(field, isoValue, options.rule, selection, progress, ranges, cells,
        [&](std::size_t s) { samples.add(s); }))
  {
    return false;
  }
  counts.assign(1, cells.count);
  return samples.finish(grow(cells.count), progress);
}

/// Several surfaces: samples are sorted by surface, so all are counted before any is placed.
template <class Work, class T>
bool sampleSeveral(const GridField<T>& field, std::span<const double> isoValues, const SampleOptions& options,
  const CellSelection& selection, MinMaxBricks* ranges, const GrowRoom& grow,
  std::vector<std::size_t>& counts, const Progress& progress)
{
  bool stopped = false;
  const Progress watch = [&](double done)
  {
    stopped = progress && !progress(0.5 * done);
    return !stopped;
  };
  const std::vector<ActiveCells> cells =
    findActiveCells(field, isoValues, options.rule, selection, watch, ranges);
  if (stopped)
  {
    return false;
  }
  std::size_t total = 0;
  for (const ActiveCells& found : cells)
  {
    counts.push_back(found.count);
    total += found.count;
  }
  SampleRoom to = grow(total);
  for (std::size_t n = 0; n < cells.size(); ++n)
  {
    const double share = 0.5 / static_cast<double>(cells.size());
    const Progress part = [&](double done)
    { return !progress || progress(0.5 + share * (static_cast<double>(n) + done)); };
    if (!placeAll<Work>(field, isoValues[n], options, cells[n], to, part))
    {
      return false;
    }
    to = roomAfter(to, cells[n].count);
  }
  return true;
}

template <class Work, class T>
bool sampleAll(const GridField<T>& field, std::span<const double> isoValues, const SampleOptions& options,
  const CellSelection& selection, MinMaxBricks* ranges, const GrowRoom& grow, std::size_t expected,
  std::vector<std::size_t>& counts, const Progress& progress)
{
  counts.clear();
  return isoValues.size() == 1
    ? sampleOne<Work>(field, isoValues.front(), options, selection, ranges, grow, expected, counts, progress)
    : sampleSeveral<Work>(field, isoValues, options, selection, ranges, grow, counts, progress);
}

/// The longest diagonal of a cell's faces, or of the cell itself: these differ if the axes are not
/// orthogonal.
/// @param dimensions 2 or 3
double longestDiagonal(const glm::dmat3& cell, int dimensions)
{
  double longest = 0.0;
  for (const double x : { -1.0, 0.0, 1.0 })
  {
    for (const double y : { -1.0, 0.0, 1.0 })
    {
      for (const double z : { -1.0, 0.0, 1.0 })
      {
        const bool isDiagonal = x * x + y * y + z * z == dimensions;
        const glm::dvec3 diagonal = cell * glm::dvec3(x, y, z);
        // Avoids overflow and underflow of squares.
        longest = isDiagonal ? std::max(longest, std::hypot(diagonal.x, diagonal.y, diagonal.z)) : longest;
      }
    }
  }
  return longest;
}

} // namespace

template <class T, class Real>
bool placeIsoSurfaceSamples(const GridField<T>& field, double isoValue, const SampleOptions& options,
  const ActiveCells& cells, std::span<Real> points, std::span<float> normals, const Progress& progress)
{
  if (points.size() != 3 * cells.count || (!normals.empty() && normals.size() != 3 * cells.count))
  {
    throw std::invalid_argument("points and normals must have three numbers for each cell");
  }
  if (cells.count == 0)
  {
    return true;
  }
  SampleRoom to;
  to.normals = normals.empty() ? nullptr : normals.data();
  to.capacity = cells.count;
  if constexpr (std::is_same_v<Real, float>)
  {
    to.points = points.data();
    if constexpr (FitsSingle<T>)
    {
      if (options.arithmetic == Arithmetic::Single)
      {
        return placeAll<float>(field, isoValue, options, cells, to, progress);
      }
    }
  }
  else
  {
    to.doublePoints = points.data();
  }
  return placeAll<double>(field, isoValue, options, cells, to, progress);
}

template <class T>
bool sampleIsoSurfaces(const GridField<T>& field, std::span<const double> isoValues,
  const SampleOptions& options, const CellSelection& selection, MinMaxBricks* ranges, const GrowRoom& grow,
  std::size_t expected, std::vector<std::size_t>& counts, const Progress& progress)
{
  if constexpr (FitsSingle<T>)
  {
    if (options.arithmetic == Arithmetic::Single)
    {
      return sampleAll<float>(field, isoValues, options, selection, ranges, grow, expected, counts, progress);
    }
  }
  return sampleAll<double>(field, isoValues, options, selection, ranges, grow, expected, counts, progress);
}

double isoSurfaceSampleRadius(const GridGeometry& geometry)
{
  return isoSurfaceSampleRadius(geometry.stepToWorld());
}

double isoSurfaceSampleArea(const glm::dmat3& cell, const glm::dvec3& normal)
{
  const glm::dvec3 along = glm::abs(normal * cell);
  return std::abs(glm::determinant(cell)) / (along.x + along.y + along.z);
}

double isoSurfaceSampleRadius(const glm::dmat3& cell)
{
  return 0.5 * longestDiagonal(cell, 3);
}

double isoSurfaceSampleReach(const glm::dmat3& cell)
{
  const double ofCell = longestDiagonal(cell, 3);
  return ofCell > 0.0 ? longestDiagonal(cell, 2) / ofCell : 0.0;
}

#define INK_INSTANTIATE(T)                                                                                   \
  template bool placeIsoSurfaceSamples(const GridField<T>&, double, const SampleOptions&,                    \
    const ActiveCells&, std::span<float>, std::span<float>, const Progress&);                                \
  template bool placeIsoSurfaceSamples(const GridField<T>&, double, const SampleOptions&,                    \
    const ActiveCells&, std::span<double>, std::span<float>, const Progress&);                               \
  template bool sampleIsoSurfaces(const GridField<T>&, std::span<const double>, const SampleOptions&,        \
    const CellSelection&, MinMaxBricks*, const GrowRoom&, std::size_t, std::vector<std::size_t>&,            \
    const Progress&);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
