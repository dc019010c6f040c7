// SPDX-License-Identifier: BSD-3-Clause
#include "IsoSurface/CellBatches.h"

#include <algorithm>

namespace ink
{

glm::ivec3 SegmentBatch::cell(int lane) const
{
  const CellSegment* segment = this->segments;
  while (lane >= segment->lane + segment->cells)
  {
    ++segment;
  }
  return { segment->x + lane - segment->lane, segment->y, segment->z };
}

SegmentParameters::SegmentParameters(const glm::ivec3& samples, const std::ptrdiff_t (&steps)[3])
  : Last(samples - 2)
  , Steps{ steps[0], steps[1], steps[2] }
{
}

void SegmentLister::enterRun(const CellRun& run)
{
  const auto& [x, y, z] = this->Terms.Steps;
  const glm::ivec3& first = run.first;
  const glm::ivec3& last = this->Terms.Last;
  this->Rest = run.cells;
  const int sides =
    (first.y == 0) | (first.y == last.y) << 1 | (first.z == 0) << 2 | (first.z == last.z) << 3;
  this->Position = { first.x, first.y, first.z, sides, first.x * x + first.y * y + first.z * z, x };
  const int toLast = last.x - first.x;
  this->Border = sides != 0 ? ~std::uint64_t(0)
                            : std::uint64_t(first.x == 0) | (toLast < 64 ? std::uint64_t(1) << toLast : 0);
}

void SegmentLister::next(SegmentBatch& batch)
{
  batch.segmentCount = 0;
  batch.count = 0;
  batch.border = false;
  while (batch.count < BatchSize && (this->Rest != 0 || this->Entered < this->Runs.size()))
  {
    if (this->Rest == 0)
    {
      this->enterRun(this->Runs[this->Entered++]);
    }
    const int listed = batch.segmentCount;
    const bool border = (this->Rest & this->Border) != 0;
    this->Rest = this->Kernels.listCells(this->Rest, this->Position, batch);
    if (border)
    {
      this->markBorder(listed, batch);
    }
  }
  const int count = batch.count;
  for (int i = count; count > 0 && i < std::min(count + SegmentSize, BatchStride); ++i)
  {
    batch.offsets[i] = batch.offsets[count - 1];
  }
}

void SegmentLister::markBorder(int firstSegment, SegmentBatch& batch) const
{
  if (!batch.border)
  {
    std::fill_n(&batch.sides[0][0], 6, std::uint64_t(0));
    batch.border = true;
  }
  for (int s = firstSegment; s < batch.segmentCount; ++s)
  {
    const CellSegment& segment = batch.segments[s];
    const std::uint64_t first = std::uint64_t(1) << segment.lane;
    const std::uint64_t all = ((std::uint64_t(1) << segment.cells) - 1) << segment.lane;
    batch.sides[0][0] |= segment.x == 0 ? first : 0;
    batch.sides[0][1] |= segment.x + segment.cells > this->Terms.Last.x ? first << (segment.cells - 1) : 0;
    for (int axis = 0; axis < 2; ++axis)
    {
      batch.sides[axis + 1][0] |= segment.sides >> 2 * axis & 1 ? all : 0;
      batch.sides[axis + 1][1] |= segment.sides >> 2 * axis & 2 ? all : 0;
    }
  }
}

} // namespace ink
