#pragma once

#include "Fields/GridField.h"
#include "Parallel/ParallelFor.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace ink
{

class BrickRanges;

/// Which edges of a grid cell the iso-surface at f0 intersects, f1 and f2 being the values at an edge's ends.
enum class CrossingRule
{
  /// f1 < f0 <= f2, or the other way round: a surface through samples has neither holes nor doubles.
  HalfOpen,
  /// As Zhang et al. 2014, section 5.1, write it: (f1 - f0)(f2 - f0) < 0, or f1 = f2 = f0. Where
  /// samples have exactly the iso-value it leaves holes, and finds flat pieces twice, from both sides.
  Strict
};

/// The cells to look at. Cell (i, j, k) has the samples (i, j, k) to (i + 1, j + 1, k + 1) as its corners.
struct CellSelection
{
  /// Cells from `begin` up to, but without, `end`; what lies outside the grid is left out.
  glm::ivec3 begin = glm::ivec3(0);
  glm::ivec3 end = glm::ivec3(std::numeric_limits<int>::max());
  /// Cells to leave out, one byte per cell of the whole grid, with i running fastest.
  ElementMarks skipped;
};

/// Up to 64 cells in a row: bit b stands for the cell (first.x + b, first.y, first.z).
struct CellRun
{
  std::uint64_t cells;
  glm::ivec3 first;
};

/// The cells that an iso-surface crosses, in the order of the grid.
struct CrossedCells
{
  /// Neighboring layers of cells, a unit of parallel work.
  struct Slab
  {
    std::vector<CellRun> runs;
    /// How many of the runs are in use while they are being found.
    std::size_t used = 0;
    /// How many cells the slabs before this one hold.
    std::size_t before = 0;
    std::size_t count = 0;
  };

  std::vector<Slab> slabs;
  std::size_t count = 0;
};

/// Finds the cells which have an edge that the iso-surface at isoValue intersects by the given rule. A cell
/// with a missing corner (hidden, NaN or infinite) has none, and neither has any cell at an isoValue of NaN.
/// \throws std::invalid_argument when the selection marks fewer cells than the grid has
/// \returns the cells, the same for any number of threads; none when `progress` asked to stop
template <class T>
CrossedCells findCrossedCells(const GridField<T>& field, double isoValue, CrossingRule rule,
  const CellSelection& selection = {}, const Progress& progress = {});

/// The same for several iso-values, in one pass over the field.
/// \param ranges when they are those of this field's values, only what the surfaces enter is read; otherwise,
/// if
///               the selection leaves nothing out, they are filled in for the next time. The caller keeps
///               them for one set of values only. Null: neither
template <class T>
std::vector<CrossedCells> findCrossedCells(const GridField<T>& field, std::span<const double> isoValues,
  CrossingRule rule, const CellSelection& selection = {}, const Progress& progress = {},
  BrickRanges* ranges = nullptr);

/// The same for one iso-value, with the slabs begun in order and `found` called, from any thread, as each is
/// complete. Their counts before are left to the caller, and so is the number of all.
/// \returns false when `progress` asked to stop
template <class T>
bool findCrossedCellsBySlab(const GridField<T>& field, double isoValue, CrossingRule rule,
  const CellSelection& selection, const Progress& progress, BrickRanges* ranges, CrossedCells& cells,
  const std::function<void(std::size_t)>& found);

} // namespace ink
