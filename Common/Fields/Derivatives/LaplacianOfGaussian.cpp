// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/Derivatives/LaplacianOfGaussian.h"

#include "Core/ParallelFor.h"
#include "Fields/Derivatives/LaplacianPasses.h"
#include "Fields/Grid/GridField.h"
#include "Fields/ScalarDifference.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace ink
{
namespace
{

/// The size of a tile, the unit of parallel work. The rows between the passes along y and z stay in the
/// cache; samples around a tile are smoothed along x again for each tile.
class Tiles
{
public:
  Tiles(const SampleBox& box, const glm::ivec3& reach, bool mixed)
    : Box(box)
  {
    const std::size_t rowBytes = (2 * reach.z + 1) * (mixed ? 3 : 2) * columns * sizeof(double);
    this->Size = { columns, static_cast<int>(std::clamp<std::size_t>(bytes / rowBytes, 8, 32)),
      std::max(64, 8 * reach.z) };
    this->Counts = (box.size() + this->Size - 1) / this->Size;
  }

  std::size_t count() const
  {
    return static_cast<std::size_t>(this->Counts.x) * this->Counts.y * this->Counts.z;
  }

  SampleBox operator[](std::size_t n) const
  {
    const int t = static_cast<int>(n);
    const glm::ivec3 at(
      t % this->Counts.x, t / this->Counts.x % this->Counts.y, t / this->Counts.x / this->Counts.y);
    const glm::ivec3 begin = this->Box.begin + at * this->Size;
    return { begin, glm::min(begin + this->Size, this->Box.end) };
  }

private:
  static constexpr int columns = 128;
  static constexpr std::size_t bytes = 320 * 1024;

  SampleBox Box;
  glm::ivec3 Size;
  glm::ivec3 Counts;
};

/// Writes a row of results; missing samples get 0.
template <class T, class Real>
void store(const GridField<T>& field, const glm::ivec3& first, const std::vector<double>& row, Real* to)
{
  constexpr double largest = static_cast<double>(std::numeric_limits<Real>::max());
  for (std::size_t i = 0; i < row.size(); ++i)
  {
    const double value = row[i] / laplacianScale<T>;
    to[i] = std::isnan(value) ? Real(0) : static_cast<Real>(std::clamp(value, -largest, largest));
  }
  const bool mayMiss = std::is_floating_point_v<T> || !field.hidden().empty();
  for (std::size_t i = 0; mayMiss && i < row.size(); ++i)
  {
    if (!field.has({ first.x + static_cast<int>(i), first.y, first.z }))
    {
      to[i] = Real(0);
    }
  }
}

} // namespace

glm::dvec3 gaussianInSamples(const GridGeometry& geometry, double scale, ScaleUnit unit)
{
  glm::dvec3 deviation(scale);
  for (int axis = 0; unit == ScaleUnit::World && axis < 3; ++axis)
  {
    const glm::dvec3& step = geometry.stepToWorld()[axis];
    deviation[axis] = scale / std::hypot(step.x, step.y, step.z);
  }
  return glm::clamp(deviation, 0.0, largestGaussian);
}

glm::ivec3 laplacianReach(const glm::dvec3& deviation)
{
  return { separableReach(deviation.x), separableReach(deviation.y), separableReach(deviation.z) };
}

template <class T, class Real>
bool laplacianOfGaussian(const GridField<T>& field, const SampleBox& box, const glm::dvec3& deviation,
  std::span<Real> laplacian, const Progress& progress)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(deviation[axis] >= 0.0 && deviation[axis] <= largestGaussian))
    {
      throw std::invalid_argument("a Gaussian's deviation must be from 0 to 16 samples");
    }
  }
  if (laplacian.size() != box.count())
  {
    throw std::invalid_argument("the array for the Laplacian has not the size of the box");
  }
  if (box.empty())
  {
    return true;
  }
  if (glm::any(glm::lessThan(box.begin, glm::ivec3(0))) ||
    glm::any(glm::greaterThan(box.end, field.geometry().dimensions())))
  {
    throw std::invalid_argument("a Laplacian is asked for outside the grid");
  }
  const LaplacianPlan<T> plan(field, deviation);
  const Tiles tiles(box, plan.reach, plan.mixed);
  const glm::ivec3 size = box.size();
  const auto run = [&](std::size_t n)
  {
    const SampleBox tile = tiles[n];
    LaplacianPasses<T>(plan, tile)
      .run(
        [&](int j, int k, const std::vector<double>& row)
        {
          const glm::ivec3 p = glm::ivec3(tile.begin.x, j, k) - box.begin;
          const std::size_t at =
            p.x + static_cast<std::size_t>(size.x) * (p.y + static_cast<std::size_t>(size.y) * p.z);
          store(field, { tile.begin.x, j, k }, row, laplacian.data() + at);
        });
  };
  return parallelFor(tiles.count(), run, progress);
}

#define INK_INSTANTIATE(T)                                                                                   \
  template bool laplacianOfGaussian(                                                                         \
    const GridField<T>&, const SampleBox&, const glm::dvec3&, std::span<float>, const Progress&);            \
  template bool laplacianOfGaussian(                                                                         \
    const GridField<T>&, const SampleBox&, const glm::dvec3&, std::span<double>, const Progress&);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
