// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Grid/GridField.h"
#include "IsoSurface/ActiveCells.h"
#include "IsoSurface/CellPlacement.h"

#include <cstddef>
#include <mutex>
#include <vector>

/// Internal to Common/IsoSurface.
namespace ink
{

/// Places the samples of a slab as soon as the number of samples before it is known, while active cells of
/// later slabs are still being found: the slab's part of the field is then still in the cache.
template <class T, class Work>
class OrderedSlabWriter
{
public:
  OrderedSlabWriter(const GridField<T>& field, double isoValue, const SampleOptions& options,
    ActiveCells& cells, const SampleRoom& room)
    : Placer(field, isoValue, options)
    , Cells(cells)
    , Room(room)
  {
  }

  /// To be called when the cells of a slab have been found.
  void add(std::size_t slab)
  {
    std::unique_lock lock(this->Guard);
    this->Found.resize(this->Cells.slabs.size());
    this->Found[slab] = true;
    while (this->Counted < this->Found.size() && this->Found[this->Counted])
    {
      ActiveCells::Slab& next = this->Cells.slabs[this->Counted++];
      next.before = this->Cells.count;
      this->Cells.count += next.count;
    }
    while (this->Taken < this->Counted && this->fits(this->Taken))
    {
      const std::size_t own = this->Taken++;
      lock.unlock();
      this->place(own);
      lock.lock();
    }
  }

  /// Places the samples that did not fit, in output arrays that are large enough.
  bool finish(const SampleRoom& room, const Progress& progress)
  {
    this->Room = room;
    const std::size_t first = this->Taken;
    const auto placeSlab = [&](std::size_t s) { this->place(first + s); };
    return parallelFor(this->Cells.slabs.size() - first, placeSlab, progress);
  }

private:
  bool fits(std::size_t slab) const
  {
    return this->Cells.slabs[slab].before + this->Cells.slabs[slab].count <= this->Room.capacity;
  }
  void place(std::size_t slab)
  {
    ActiveCells::Slab& own = this->Cells.slabs[slab];
    this->Placer.place(own.runs, roomAfter(this->Room, own.before));
    own.runs = {};
  }

  CellPlacement<T, Work> Placer;
  ActiveCells& Cells;
  SampleRoom Room;
  std::mutex Guard;
  std::vector<char> Found;
  std::size_t Counted = 0; ///< slabs whose position in the output is known
  std::size_t Taken = 0;   ///< slabs that are placed or being placed
};

} // namespace ink
