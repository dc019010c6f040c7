// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Fields/Grid/ElementMarks.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace ink
{

class MinMaxBricks;
template <class T>
class GridField;

/// Which edges of a grid cell the iso-surface at f0 intersects, with f1 and f2 the values at an edge's ends.
enum class CrossingRule
{
  /// f1 < f0 <= f2, or vice versa: a surface through samples has neither holes nor duplicates.
  HalfOpen,
  /// As printed in Zhang et al. (2014, section 5.1): (f1 - f0)(f2 - f0) < 0, or f1 = f2 = f0. Where samples
  /// have exactly the iso-value it leaves holes, and finds flat regions twice, from both sides.
  Strict
};

/// The cells to process. Cell (i, j, k) has the samples (i, j, k) to (i + 1, j + 1, k + 1) as corners.
struct CellSelection
{
  /// Cells from `begin` up to but excluding `end`, clipped to the grid.
  glm::ivec3 begin = glm::ivec3(0);
  glm::ivec3 end = glm::ivec3(std::numeric_limits<int>::max());
  /// Cells to skip, one byte per cell of the whole grid, i fastest.
  ElementMarks skipped;
};

/// Up to 64 cells in a row: bit b stands for the cell (first.x + b, first.y, first.z).
struct CellRun
{
  std::uint64_t cells;
  glm::ivec3 first;
};

/// The active cells of an iso-surface, in grid order.
struct ActiveCells
{
  /// Consecutive layers of cells, a unit of parallel work.
  struct Slab
  {
    std::vector<CellRun> runs;
    /// The number of valid runs during the search.
    std::size_t used = 0;
    /// The number of cells in all slabs before this one.
    std::size_t before = 0;
    std::size_t count = 0;
  };

  std::vector<Slab> slabs;
  std::size_t count = 0;
};

/// Finds the active cells: those with an edge that the iso-surface intersects by the given rule. Cells with a
/// missing corner (hidden, NaN or infinite) are never active; for an isoValue of NaN no cell is.
/// @throws std::invalid_argument when the selection marks fewer cells than the grid has
/// @return the cells, the same for any number of threads; none when `progress` asked to stop
template <class T>
ActiveCells findActiveCells(const GridField<T>& field, double isoValue, CrossingRule rule,
  const CellSelection& selection = {}, const Progress& progress = {});

/// The same for several iso-values, in one pass over the field.
/// @param ranges if filled from these values, only bricks that the surfaces enter are read; otherwise, if all
///   cells are selected, they are filled for the next call. The caller must clear them when the values
///   change. May be null
template <class T>
std::vector<ActiveCells> findActiveCells(const GridField<T>& field, std::span<const double> isoValues,
  CrossingRule rule, const CellSelection& selection = {}, const Progress& progress = {},
  MinMaxBricks* ranges = nullptr);

/// The same for one iso-value: slabs are started in order, and `found` is called, from any thread, when one
/// is complete. The caller computes Slab::before and the total count.
/// @return false when `progress` asked to stop
template <class T>
bool findActiveCellsBySlab(const GridField<T>& field, double isoValue, CrossingRule rule,
  const CellSelection& selection, const Progress& progress, MinMaxBricks* ranges, ActiveCells& cells,
  const std::function<void(std::size_t)>& found);

} // namespace ink
