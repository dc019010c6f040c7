// SPDX-License-Identifier: BSD-3-Clause
// Contours of a volume's iso-surface for eyes around it against the cold iso-surface sampler, which finds all
// active cells and places a point with a normal in each: the same volumes, iso-values and threads, one after
// the other, in one process.
//   BenchmarkGridContours [FILE X Y Z ISO]
// Of analytic shapes in 256^3 voxels; or of the volume of X x Y x Z unsigned bytes at the end of a file, such
// as .raw or uncompressed .nii. Prints processor time, the least of several runs, mean over the eyes.
// VTK_SMP_MAX_THREADS is 1 unless it is set.

#include "AnalyticFields.h"
#include "Curves/Contours/GridContours.h"
#include "IsoSurface/IsoSurfaceSamples.h"
#include "IsoSurface/MinMaxBricks.h"
#include "ProcessorTime.h"
#include "SampledVolume.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace
{

using namespace ink::testing;
using ink::Eye;

constexpr int Eyes = 12;

/// On a circle around the volume that leaves out its symmetry axes; every other one at infinity.
Eye eyeAround(const ink::GridGeometry& grid, int n)
{
  const glm::dvec3 size = grid.stepToWorld() * glm::dvec3(grid.dimensions());
  const double angle = 0.3 + 2.0 * std::acos(-1.0) * n / Eyes;
  const glm::dvec3 direction = glm::normalize(glm::dvec3(std::cos(angle), std::sin(angle), 0.6));
  return n % 2
    ? Eye::along(direction)
    : Eye::at(grid.toWorld(0.5 * glm::dvec3(grid.dimensions() - 1)) + 1.5 * glm::length(size) * direction);
}

template <class T>
void measure(const std::string& name, const ink::GridField<T>& field, double isoValue)
{
  std::vector<float> points;
  std::vector<float> normals;
  std::size_t cells = 0;
  const double cold = LeastProcessorTime(5,
    [&]
    {
      ink::MinMaxBricks ranges;
      const auto active = ink::findActiveCells(
        field, std::span<const double>(&isoValue, 1), ink::CrossingRule::HalfOpen, {}, {}, &ranges);
      cells = active.front().count;
      points.resize(3 * cells);
      normals.resize(3 * cells);
      ink::placeIsoSurfaceSamples(
        field, isoValue, {}, active.front(), std::span<float>(points), std::span<float>(normals));
    });
  std::unique_ptr<const ink::GridContours<T>> contours;
  const double build =
    LeastProcessorTime(2, [&] { contours = std::make_unique<const ink::GridContours<T>>(field, isoValue); });
  std::size_t count = 0;
  std::size_t chains = 0;
  std::size_t bricks = 0;
  const auto meanOver = [&](int runs, const ink::GridContourOptions& options)
  {
    double sum = 0.0;
    count = chains = bricks = 0;
    for (int n = 0; n < Eyes; ++n)
    {
      const Eye eye = eyeAround(field.geometry(), n);
      ink::Contours found;
      sum += LeastProcessorTime(runs, [&] { found = contours->find(eye, {}, options); });
      count += found.positions.size();
      chains += found.chains.size();
      bricks += contours->searchedBrickCount(eye);
    }
    return sum / Eyes;
  };
  ink::GridContourOptions options;
  options.search = ink::SilhouetteSearch::Exhaustive;
  const double exhaustive = meanOver(1, options);
  options.search = ink::SilhouetteSearch::Hierarchy;
  options.projectionSteps = 2;
  const double projected = meanOver(1, options);
  const double time = meanOver(5, {});
  std::printf(
    "%s: %zu active cells; sampler %.2f ms; index %.1f ms; contours %.2f ms (%.1f %%), exhaustive %.2f "
    "ms, with 2 projection steps %.2f ms; %zu points in %zu chains; %zu of %zu bricks\n",
    name.c_str(), cells, cold, build, time, 100.0 * time / cold, exhaustive, projected, count / Eyes,
    chains / Eyes, bricks / Eyes, contours->brickCount());
}

int measureFile(char* argv[])
{
  const glm::ivec3 size(std::atoi(argv[2]), std::atoi(argv[3]), std::atoi(argv[4]));
  if (size.x < 2 || size.y < 2 || size.z < 2)
  {
    std::cerr << "X Y Z: expected at least 2 each" << std::endl;
    return EXIT_FAILURE;
  }
  Volume<unsigned char> volume{ ink::GridGeometry(size) };
  std::ifstream file(argv[1], std::ios::binary);
  const auto bytes = static_cast<std::streamoff>(volume.values.size());
  file.seekg(-bytes, std::ios::end);
  if (!file.read(reinterpret_cast<char*>(volume.values.data()), bytes))
  {
    std::cerr << argv[1] << ": expected " << bytes << " bytes" << std::endl;
    return EXIT_FAILURE;
  }
  measure(argv[1], volume.field(), std::atof(argv[5]));
  return EXIT_SUCCESS;
}

} // namespace

int main(int argc, char* argv[])
{
  setenv("VTK_SMP_MAX_THREADS", "1", 0);
  if (argc == 6)
  {
    return measureFile(argv);
  }
  const ink::GridGeometry grid(glm::ivec3(256), glm::dvec3(-127.5));
  const Sphere sphere{ { 0.1, 0.2, 0.3 }, 100.0 };
  const Torus torus{ 80.0, 30.0 };
  measure("sphere, float",
    Volume<float>::from(grid, [&](const glm::dvec3& p) { return -sphere.distance(p); }).field(), 0.0);
  measure("torus, float",
    Volume<float>::from(grid, [&](const glm::dvec3& p) { return -torus.distance(p); }).field(), 0.0);
  measure("scanned torus, short",
    Volume<short>::from(
      grid, [&](const glm::dvec3& p) { return 2000.0 * std::erfc(torus.distance(p) / std::sqrt(2.0)); })
      .field(),
    2000.5);
  return EXIT_SUCCESS;
}
