#include "Sampling/CellSegments.h"

#include <algorithm>

namespace ink
{
namespace
{

/// Of what has one: std::countr_zero must ask first.
int lowestBit(std::uint64_t bits)
{
  return __builtin_ctzll(bits);
}

} // namespace

glm::ivec3 SegmentBatch::cell(int lane) const
{
  const CellSegment* segment = this->segments;
  while (lane >= segment->lane + segment->cells)
  {
    ++segment;
  }
  return { segment->x + lane - segment->lane, segment->y, segment->z };
}

SegmentTerms::SegmentTerms(const glm::ivec3& samples, const std::ptrdiff_t (&steps)[3])
  : Last(samples - 2)
  , Steps{ steps[0], steps[1], steps[2] }
{
  for (int i = 0; i < SegmentSize; ++i)
  {
    this->Along[i] = i * steps[0];
  }
}

void SegmentLister::enterRun(const CellRun& run)
{
  this->Rest = run.cells;
  this->First = run.first;
  this->Offset = run.first.x * this->Terms.Steps[0] + run.first.y * this->Terms.Steps[1] +
    run.first.z * this->Terms.Steps[2];
  const glm::ivec3& last = this->Terms.Last;
  this->Sides = (run.first.y == 0) | (run.first.y == last.y) << 1 | (run.first.z == 0) << 2 |
    (run.first.z == last.z) << 3;
}

void SegmentLister::next(SegmentBatch& batch)
{
  batch.segmentCount = 0;
  batch.border = false;
  int count = 0;
  while (count < BatchSize)
  {
    if (this->Rest == 0)
    {
      if (this->Entered == this->Runs.size())
      {
        break;
      }
      this->enterRun(this->Runs[this->Entered++]);
      continue;
    }
    const int start = lowestBit(this->Rest);
    const int most = std::min(SegmentSize, BatchSize - count);
    const int cells = lowestBit(~(this->Rest >> start) | std::uint64_t(1) << most);
    this->Rest &= ~(((std::uint64_t(1) << cells) - 1) << start);

    CellSegment& segment = batch.segments[batch.segmentCount++];
    segment.x = this->First.x + start;
    segment.y = this->First.y;
    segment.z = this->First.z;
    segment.lane = static_cast<std::int16_t>(count);
    segment.cells = static_cast<std::int8_t>(cells);
    segment.sides = static_cast<std::int8_t>(this->Sides);
    // Always so many, because a branch that follows their number is foretold wrongly.
    const std::ptrdiff_t first = this->Offset + start * this->Terms.Steps[0];
    for (int i = 0; i < SegmentSize; ++i)
    {
      batch.offsets[count + i] = first + this->Terms.Along[i];
    }
    if ((this->Sides != 0) | (segment.x == 0) | (segment.x + cells > this->Terms.Last.x))
    {
      this->markBorder(segment, batch);
    }
    count += cells;
  }
  batch.count = count;
  for (int i = count; count > 0 && i < std::min(count + SegmentSize, BatchStride); ++i)
  {
    batch.offsets[i] = batch.offsets[count - 1];
  }
}

void SegmentLister::markBorder(const CellSegment& segment, SegmentBatch& batch) const
{
  if (!batch.border)
  {
    std::fill_n(&batch.sides[0][0], 6, std::uint64_t(0));
    batch.border = true;
  }
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

} // namespace ink
