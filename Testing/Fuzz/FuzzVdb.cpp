// SPDX-License-Identifier: BSD-3-Clause
// What reads .vdb files, given any bytes: lists the grids, reads each that can be read, samples it and copies
// a part of it. Nothing but a VdbError may come out. `make fuzz` runs it with libFuzzer, and the ordinary
// test FuzzCorpus.vdb runs it over the files in Corpus/vdb: seeds, and all that ever made it fall.

#include "IsoSurface/Vdb/VdbSamples.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace
{

/// Enough for every seed, little enough for a machine that fuzzes all day.
constexpr std::uint64_t memory = 16 << 20;
constexpr std::uint64_t surfaceMemory = 4 << 20;

template <class Real>
void useGrid(const ink::VdbGrid& grid)
{
  const double iso = 0.5 * grid.background() + 0.25;
  for (const ink::CrossingRule rule : { ink::CrossingRule::HalfOpen, ink::CrossingRule::Strict })
  {
    const ink::VdbActiveCells cells = ink::findActiveCells(grid, iso, rule, false, {}, surfaceMemory);
    // What more of them would say takes long.
    if (cells.count > 20'000)
    {
      continue;
    }
    std::vector<double> points(3 * cells.count);
    std::vector<float> normals(3 * cells.count);
    ink::placeIsoSurfaceSamples(
      grid, iso, { rule }, false, cells, std::span<double>(points), std::span<float>(normals));
    for (const float normal : normals)
    {
      if (!std::isfinite(normal))
      {
        std::abort();
      }
    }
  }
  ink::VoxelBox box = grid.activeBox();
  if (!box.empty())
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      // The box may be as wide as all integers.
      const std::int64_t width = static_cast<std::int64_t>(box.last[axis]) - box.first[axis];
      box.last[axis] = box.first[axis] + static_cast<int>(width < 20 ? width : 20);
    }
    const glm::dvec3 size = box.size();
    std::vector<Real> values(static_cast<std::size_t>(size.x * size.y * size.z));
    grid.copyTo(box, true, std::span<Real>(values));
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::istringstream in(std::string(reinterpret_cast<const char*>(data), size), std::ios::binary);
  try
  {
    const ink::VdbFile file = ink::VdbFile::list(in);
    int read = 0;
    for (const ink::VdbGridInfo& info : file.grids)
    {
      // A few say as much as the many that a file may list.
      if (!info.problem.empty() || ++read > 4)
      {
        continue;
      }
      try
      {
        const ink::VdbGrid grid = ink::VdbGrid::read(in, file, info, memory);
        if (info.isDouble)
        {
          useGrid<double>(grid);
        }
        else
        {
          useGrid<float>(grid);
        }
      }
      catch (const ink::VdbError&)
      {
        continue;
      }
    }
  }
  catch (const ink::VdbError&)
  {
    return 0;
  }
  return 0;
}
