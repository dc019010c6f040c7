// SPDX-License-Identifier: BSD-3-Clause
// From bits to lists of cells. Included inside a namespace without a name.

std::uint64_t listCells(std::uint64_t cells, const RunPosition& run, SegmentList& list)
{
  int count = list.count;
  CellSegment* segment = list.segments + list.segmentCount;
  while (cells != 0 && count < BatchSize)
  {
    const int room = BatchSize - count;
    const int most = room < SegmentSize ? room : SegmentSize;
    const int start = __builtin_ctzll(cells);
    const int length = __builtin_ctzll(~(cells >> start) | std::uint64_t(1) << most);
    cells &= ~(((std::uint64_t(1) << length) - 1) << start);
    *segment++ = { run.x + start, run.y, run.z, static_cast<std::int16_t>(count),
      static_cast<std::int8_t>(length), static_cast<std::int8_t>(run.sides) };
    // Always so many, because a branch that follows their number is foretold wrongly.
    const std::ptrdiff_t first = run.offset + start * run.step;
    for (int i = 0; i < SegmentSize; ++i)
    {
      list.offsets[count + i] = first + i * run.step;
    }
    count += length;
  }
  list.segmentCount = static_cast<std::int32_t>(segment - list.segments);
  list.count = count;
  return cells;
}

void findCorners(
  const SegmentList& list, const float* x, const float* y, const float* z, CellBatch<float>& batch)
{
  typedef float Copy __attribute__((vector_size(BlockBytes)));
  constexpr int several = BlockBytes / 4;
  for (int s = 0; s < list.segmentCount; ++s)
  {
    const CellSegment& segment = list.segments[s];
    for (int i = 0; i < SegmentSize; i += several)
    {
      const int lane = segment.lane + i;
      __builtin_memcpy(&batch.corners[0][lane], x + segment.x + i, sizeof(Copy));
      storeVector(&batch.corners[1][lane], Copy{} + y[segment.y]);
      storeVector(&batch.corners[2][lane], Copy{} + z[segment.z]);
    }
  }
}
