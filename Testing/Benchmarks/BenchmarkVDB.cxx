// SPDX-License-Identifier: BSD-3-Clause
// A thin surface in a large box: points straight from the sparse grid against the same points of its dense
// image.
//   BenchmarkVDB [SIZE]     a sphere in SIZE^3 voxels (512)
// Prints the processor time of each step, the least of several runs, and the memory that the data takes.

#include "Fields/Grid/GridField.h"
#include "Fields/Vdb/VdbWrite.h"
#include "IsoSurface/Vdb/VdbSamples.h"
#include "ProcessorTime.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <span>
#include <sstream>
#include <string>
#include <vector>

namespace
{

constexpr int Runs = 7;

void print(const std::string& what, double milliseconds, std::size_t bytes)
{
  std::cout << what << ": " << milliseconds << " ms, " << static_cast<double>(bytes) / (1 << 20) << " MiB"
            << std::endl;
}

} // namespace

int main(int argc, char* argv[])
{
  const int size = argc > 1 ? std::atoi(argv[1]) : 512;
  if (size < 16 || size > 2048)
  {
    std::cerr << "SIZE: expected 16 to 2048" << std::endl;
    return EXIT_FAILURE;
  }
  setenv("VTK_SMP_MAX_THREADS", "1", 0);
  const ink::GridGeometry geometry({ size, size, size });
  std::vector<float> values(geometry.sampleCount());
  const double middle = 0.5 * (size - 1);
  std::size_t n = 0;
  for (int k = 0; k < size; ++k)
  {
    for (int j = 0; j < size; ++j)
    {
      for (int i = 0; i < size; ++i)
      {
        values[n++] = static_cast<float>(0.4 * size + 0.3 - std::hypot(i - middle, j - middle, k - middle));
      }
    }
  }
  const ink::GridField<float> volume(geometry, std::span<const float>(values));
  ink::VdbConversion conversion;
  conversion.around = 0.0;
  const std::string file = ink::serializeVdb(ink::makeVdbGrid(volume, conversion));
  std::istringstream in(file);
  const ink::VdbFile list = ink::VdbFile::list(in);
  const ink::VdbGrid grid = ink::VdbGrid::read(in, list, list.find(""));

  ink::ActiveCells denseCells;
  ink::VdbActiveCells sparseCells;
  const ink::CrossingRule rule = ink::CrossingRule::HalfOpen;
  const double findDense =
    LeastProcessorTime(Runs, [&] { denseCells = ink::findActiveCells(volume, 0.0, rule); });
  const double findSparse =
    LeastProcessorTime(Runs, [&] { sparseCells = ink::findActiveCells(grid, 0.0, rule, false); });
  std::vector<float> points(3 * sparseCells.count);
  std::vector<float> normals(3 * sparseCells.count);
  const auto spans = [&] { return std::span<float>(points); };
  const double placeDense = LeastProcessorTime(Runs,
    [&]
    { ink::placeIsoSurfaceSamples(volume, 0.0, { rule }, denseCells, spans(), std::span<float>(normals)); });
  const double placeSparse = LeastProcessorTime(Runs,
    [&]
    {
      ink::placeIsoSurfaceSamples(
        grid, 0.0, { rule }, false, sparseCells, spans(), std::span<float>(normals));
    });
  const double read = LeastProcessorTime(Runs, [&] { ink::VdbGrid::read(in, list, list.find("")); });
  const double densify =
    LeastProcessorTime(Runs, [&] { grid.copyTo(grid.domain(), false, std::span<float>(values)); });

  std::cout << denseCells.count << " points dense, " << sparseCells.count << " sparse, in " << size
            << "^3 voxels, file of " << static_cast<double>(file.size()) / (1 << 20) << " MiB\n";
  const std::size_t denseBytes = values.size() * sizeof(float);
  print("read the grid", read, grid.memory());
  print("make it dense", densify, denseBytes);
  print("dense: find cells", findDense, denseBytes);
  print("dense: samples", placeDense, denseBytes);
  print("sparse: find cells", findSparse, grid.memory());
  print("sparse: samples", placeSparse, grid.memory());
  std::cout << "sparse / dense, sampling alone: " << (findSparse + placeSparse) / (findDense + placeDense)
            << ", with making it dense: " << (findSparse + placeSparse) / (densify + findDense + placeDense)
            << ", memory: " << static_cast<double>(grid.memory()) / static_cast<double>(denseBytes)
            << std::endl;
  return EXIT_SUCCESS;
}
