#pragma once

#include "Sampling/CrossedCells.h"
#include "Sampling/SamplePlacer.h"

#include <cstddef>
#include <mutex>
#include <vector>

/// Internal to Common/Sampling.
namespace ink
{

/// Places the samples of slabs while others are still being found, each as soon as the number of those before
/// it is known: its part of the field is then still in the cache.
template <class T, class Work>
class SamplesOnTheWay
{
public:
  SamplesOnTheWay(const GridField<T>& field, double isoValue, const SampleOptions& options,
    CrossedCells& cells, const SampleRoom& room)
    : Placer(field, isoValue, options)
    , Cells(cells)
    , Room(room)
  {
  }

  /// To be called when a slab has been found.
  void add(std::size_t slab)
  {
    std::unique_lock lock(this->Guard);
    this->Found.resize(this->Cells.slabs.size());
    this->Found[slab] = true;
    while (this->Counted < this->Found.size() && this->Found[this->Counted])
    {
      CrossedCells::Slab& next = this->Cells.slabs[this->Counted++];
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

  /// Places those that the room was too small for, in one that is large enough.
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
    CrossedCells::Slab& own = this->Cells.slabs[slab];
    this->Placer.place(own.runs, roomAfter(this->Room, own.before));
    own.runs = {};
  }

  SamplePlacer<T, Work> Placer;
  CrossedCells& Cells;
  SampleRoom Room;
  std::mutex Guard;
  std::vector<char> Found;
  std::size_t Counted = 0; ///< slabs whose place is known
  std::size_t Taken = 0;   ///< slabs that are placed or being placed
};

} // namespace ink
