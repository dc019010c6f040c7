// SPDX-License-Identifier: BSD-3-Clause
#include "IsoSurface/ActiveCells.h"

#include "Core/ParallelFor.h"
#include "Fields/Grid/GridField.h"
#include "Fields/ScalarDifference.h"
#include "IsoSurface/ActiveCellFinder.h"
#include "IsoSurface/MinMaxBricks.h"

#include <glm/common.hpp>

#include <atomic>
#include <stdexcept>
#include <utility>

namespace ink
{
namespace
{

template <class T>
bool findAll(const GridField<T>& field, std::span<const double> isoValues, CrossingRule rule,
  const CellSelection& selection, const Progress& progress, MinMaxBricks* ranges,
  std::span<ActiveCells> cells, const std::function<void(std::size_t)>& found)
{
  const glm::ivec3 size = glm::max(field.geometry().dimensions() - 1, glm::ivec3(0));
  const std::size_t count = static_cast<std::size_t>(size.x) * size.y * size.z;
  if (!selection.skipped.empty() && selection.skipped.bytes.size() < count)
  {
    throw std::invalid_argument("the grid has more cells than marks were given");
  }
  ActiveCellFinder<T> finder(field, isoValues, rule, selection);
  finder.use(ranges);
  for (ActiveCells& all : cells)
  {
    all = {};
    all.slabs.resize(finder.slabCount());
  }
  if (isoValues.empty())
  {
    return true;
  }
  // In order, whatever the scheduling of threads.
  std::atomic<int> next = 0;
  const auto find = [&](std::size_t)
  {
    const int slab = next++;
    finder.find(slab, cells);
    found(static_cast<std::size_t>(slab));
  };
  if (!parallelFor(finder.slabCount(), find, progress))
  {
    return false;
  }
  if (finder.measures())
  {
    ranges->setComplete();
  }
  return true;
}

} // namespace

template <class T>
std::vector<ActiveCells> findActiveCells(const GridField<T>& field, std::span<const double> isoValues,
  CrossingRule rule, const CellSelection& selection, const Progress& progress, MinMaxBricks* ranges)
{
  std::vector<ActiveCells> cells(isoValues.size());
  if (!findAll<T>(field, isoValues, rule, selection, progress, ranges, cells, [](std::size_t) {}))
  {
    return std::vector<ActiveCells>(isoValues.size());
  }
  for (ActiveCells& all : cells)
  {
    for (ActiveCells::Slab& slab : all.slabs)
    {
      slab.before = all.count;
      all.count += slab.count;
    }
  }
  return cells;
}

template <class T>
bool findActiveCellsBySlab(const GridField<T>& field, double isoValue, CrossingRule rule,
  const CellSelection& selection, const Progress& progress, MinMaxBricks* ranges, ActiveCells& cells,
  const std::function<void(std::size_t)>& found)
{
  return findAll<T>(field, std::span<const double>(&isoValue, 1), rule, selection, progress, ranges,
    std::span<ActiveCells>(&cells, 1), found);
}

template <class T>
ActiveCells findActiveCells(const GridField<T>& field, double isoValue, CrossingRule rule,
  const CellSelection& selection, const Progress& progress)
{
  return std::move(
    findActiveCells(field, std::span<const double>(&isoValue, 1), rule, selection, progress).front());
}

#define INK_INSTANTIATE(T)                                                                                   \
  template ActiveCells findActiveCells(                                                                      \
    const GridField<T>&, double, CrossingRule, const CellSelection&, const Progress&);                       \
  template std::vector<ActiveCells> findActiveCells(const GridField<T>&, std::span<const double>,            \
    CrossingRule, const CellSelection&, const Progress&, MinMaxBricks*);                                     \
  template bool findActiveCellsBySlab(const GridField<T>&, double, CrossingRule, const CellSelection&,       \
    const Progress&, MinMaxBricks*, ActiveCells&, const std::function<void(std::size_t)>&);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
