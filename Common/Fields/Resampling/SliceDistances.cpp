// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/Resampling/SliceDistances.h"

#include "Core/OtherAxes.h"
#include "Core/ParallelFor.h"
#include "Fields/Grid/GridField.h"
#include "Fields/Grid/RowReader.h"
#include "Fields/ScalarDifference.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

namespace ink
{
namespace
{

/// The distances of a slice's samples from a contour. The state of one thread.
class ContourDistances
{
public:
  /// @param size of a slice
  ContourDistances(const glm::ivec2& size, const ThickSlices& slices)
    : Size(size)
    , Sides(slices.sides)
    , Reach(slices.reach)
    , Samples(static_cast<std::size_t>(size.x) * size.y)
  {
  }

  /// @param values of the slice; NaN where missing
  void measure(std::span<const double> values, double isoValue)
  {
    this->findSegments(values, isoValue);
    this->spread();
  }

  double at(std::size_t sample) const { return std::sqrt(this->Samples[sample].squaredDistance); }

private:
  /// A piece of the contour in a cell; ends in shares of the cell's sides.
  struct Segment
  {
    glm::ivec2 cell;
    glm::dvec2 begin;
    glm::dvec2 end;
  };
  struct Nearest
  {
    double squaredDistance;
    std::int32_t segment; ///< -1: none within reach
  };

  /// Row by row.
  void findSegments(std::span<const double> values, double isoValue)
  {
    this->Segments.clear();
    const auto width = static_cast<std::size_t>(this->Size.x);
    for (int j = 0; j + 1 < this->Size.y; ++j)
    {
      const double* row = values.data() + width * static_cast<std::size_t>(j);
      for (int i = 0; i + 1 < this->Size.x; ++i)
      {
        this->addSegments({ i, j }, { row[i], row[i + 1], row[i + width + 1], row[i + width] }, isoValue);
      }
    }
  }

  /// @param values at the cell's corners, one after the other around it
  void addSegments(const glm::ivec2& cell, const std::array<double, 4>& values, double isoValue)
  {
    static const std::array<glm::dvec2, 5> corners = { glm::dvec2(0.0, 0.0), glm::dvec2(1.0, 0.0),
      glm::dvec2(1.0, 1.0), glm::dvec2(0.0, 1.0), glm::dvec2(0.0, 0.0) };
    std::array<glm::dvec2, 4> crossings;
    std::size_t count = 0;
    for (std::size_t c = 0; c < 4; ++c)
    {
      const double from = values[c];
      const double to = values[(c + 1) % 4];
      if ((from >= isoValue) != (to >= isoValue))
      {
        // By halves, as differences overflow.
        const double share = (0.5 * isoValue - 0.5 * from) / (0.5 * to - 0.5 * from);
        crossings[count++] = glm::mix(corners[c], corners[c + 1], share);
      }
    }
    const double middle = 0.25 * values[0] + 0.25 * values[1] + 0.25 * values[2] + 0.25 * values[3];
    if (count == 0 || std::isnan(middle))
    {
      return;
    }
    if (count == 2)
    {
      this->Segments.push_back({ cell, crossings[0], crossings[1] });
      return;
    }
    // Each of a saddle's two goes around a corner that is unlike the middle.
    const std::size_t first = (values[0] >= isoValue) == (middle >= isoValue) ? 0 : 3;
    for (const std::size_t c : { first, first + 2 })
    {
      this->Segments.push_back({ cell, crossings[c % 4], crossings[(c + 1) % 4] });
    }
  }

  /// Hands segments on from sample to sample, all by one step at a time, as long as they are the nearest.
  void spread()
  {
    std::fill(this->Samples.begin(), this->Samples.end(), Nearest{ this->Reach * this->Reach, -1 });
    this->Changed.clear();
    for (std::size_t n = 0; n < this->Segments.size(); ++n)
    {
      this->offerAround(this->Segments[n].cell, this->Segments[n].cell + 2, static_cast<std::int32_t>(n));
    }
    while (!this->Changed.empty())
    {
      this->Front.clear();
      for (const glm::ivec2& sample : this->Changed)
      {
        this->Front.emplace_back(sample, this->Samples[this->offset(sample)].segment);
      }
      // Some more than once, which does not matter.
      this->Changed.clear();
      for (const auto& [sample, segment] : this->Front)
      {
        this->offerAround(sample - 1, sample + 2, segment);
      }
    }
  }

  std::size_t offset(const glm::ivec2& sample) const
  {
    return static_cast<std::size_t>(sample.x) + static_cast<std::size_t>(this->Size.x) * sample.y;
  }

  void offerAround(const glm::ivec2& low, const glm::ivec2& high, std::int32_t segment)
  {
    const glm::ivec2 begin = glm::max(low, glm::ivec2(0));
    const glm::ivec2 end = glm::min(high, this->Size);
    for (int j = begin.y; j < end.y; ++j)
    {
      for (int i = begin.x; i < end.x; ++i)
      {
        Nearest& nearest = this->Samples[this->offset({ i, j })];
        if (nearest.segment == segment)
        {
          continue;
        }
        const double distance = this->squaredDistance({ i, j }, this->Segments[segment]);
        // Of two as near, the first in order, so that all parts of a slice agree.
        if (distance < nearest.squaredDistance ||
          (distance == nearest.squaredDistance && segment < nearest.segment))
        {
          nearest = { distance, segment };
          this->Changed.emplace_back(i, j);
        }
      }
    }
  }

  double squaredDistance(const glm::ivec2& sample, const Segment& segment) const
  {
    const glm::dvec2 corner = segment.cell - sample;
    const glm::dvec2 begin = (corner + segment.begin) * this->Sides;
    const glm::dvec2 along = (corner + segment.end) * this->Sides - begin;
    const double length = glm::dot(along, along);
    const double share = length > 0.0 ? std::clamp(-glm::dot(begin, along) / length, 0.0, 1.0) : 0.0;
    const glm::dvec2 nearest = begin + share * along;
    return glm::dot(nearest, nearest);
  }

  glm::ivec2 Size;
  glm::dvec2 Sides;
  double Reach;
  std::vector<Nearest> Samples;
  std::vector<Segment> Segments;
  std::vector<glm::ivec2> Changed;
  std::vector<std::pair<glm::ivec2, std::int32_t>> Front;
};

/// Reads a slice row by row; NaN where samples are missing.
template <class T>
void readSlice(
  const GridField<T>& field, int axis, int slice, const glm::ivec2& size, std::span<double> values)
{
  // Across x, each sample is a row.
  const std::size_t length = axis == 0 ? 1 : static_cast<std::size_t>(size.x);
  std::vector<std::uint8_t> marks(length);
  const std::size_t rows = axis == 0 ? values.size() : static_cast<std::size_t>(size.y);
  for (std::size_t n = 0; n < rows; ++n)
  {
    const auto nth = static_cast<std::int64_t>(n);
    const int j = static_cast<int>(axis == 0 ? nth % size.x : axis == 1 ? slice : nth);
    const int k = static_cast<int>(axis == 0 ? nth / size.x : axis == 1 ? nth : slice);
    const std::span<double> row = values.subspan(n * length, length);
    if (!readRow<T, double>(
          field, j, k, axis == 0 ? slice : 0, std::numeric_limits<double>::infinity(), row, marks))
    {
      continue;
    }
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      row[i] = marks[i] == Missing ? std::numeric_limits<double>::quiet_NaN() : row[i];
    }
  }
}

} // namespace

double ThickSlices::ratio() const
{
  return this->distance / std::max(this->sides.x, this->sides.y);
}

glm::ivec3 ThickSlices::samples() const
{
  const auto [u, v] = otherAxes(this->axis);
  glm::ivec3 samples(0);
  samples[u] = static_cast<int>(std::ceil(this->reach / this->sides.x)) + 1;
  samples[v] = static_cast<int>(std::ceil(this->reach / this->sides.y)) + 1;
  return samples;
}

std::optional<ThickSlices> thickSlices(const glm::dvec3& spacing)
{
  const glm::dvec3 size = glm::abs(spacing);
  const glm::dvec3 ratios = size / std::min({ size.x, size.y, size.z });
  const int axis = ratios.x > std::max(ratios.y, ratios.z) ? 0 : ratios.y > ratios.z ? 1 : 2;
  const auto [u, v] = otherAxes(axis);
  // Surfaces at 56 degrees to the slices' axis, or less, move by no more from one to the next; the samples on
  // both sides of a contour are within reach.
  constexpr double steepness = 1.5;
  const double reach = std::max(
    std::min(steepness * ratios[axis], ThickSlices::largestReach), 2.0 * std::max(ratios[u], ratios[v]));
  const ThickSlices slices = { axis, { ratios[u], ratios[v] }, ratios[axis], reach };
  return slices.ratio() >= ThickSlices::leastRatio ? std::optional(slices) : std::nullopt;
}

template <class T>
std::vector<float> sliceDistances(const GridField<T>& field, double isoValue, bool ofMask,
  const ThickSlices& slices, const Progress& progress)
{
  const glm::ivec3& dimensions = field.geometry().dimensions();
  const auto [u, v] = otherAxes(slices.axis);
  const std::array<std::size_t, 3> strides = { 1, static_cast<std::size_t>(dimensions.x),
    static_cast<std::size_t>(dimensions.x) * dimensions.y };
  const std::size_t along = strides[static_cast<std::size_t>(slices.axis)];
  const std::size_t alongU = strides[static_cast<std::size_t>(u)];
  const std::size_t alongV = strides[static_cast<std::size_t>(v)];
  const glm::ivec2 size(dimensions[u], dimensions[v]);
  struct Workspace
  {
    std::vector<double> values;
    ContourDistances distances;
  };
  tbb::enumerable_thread_specific<Workspace> workspaces(
    [&]
    {
      return Workspace{ std::vector<double>(static_cast<std::size_t>(size.x) * size.y),
        ContourDistances(size, slices) };
    });
  std::vector<float> all(field.geometry().sampleCount());
  const auto measure = [&](std::size_t slice)
  {
    auto& [values, distances] = workspaces.local();
    readSlice(field, slices.axis, static_cast<int>(slice), size, values);
    if (ofMask)
    {
      // Missing ones stay.
      std::transform(values.begin(), values.end(), values.begin(),
        [&](double value) { return std::isnan(value) ? value
                              : value >= isoValue    ? 1.0
                                                     : -1.0; });
    }
    const double level = ofMask ? 0.0 : isoValue;
    distances.measure(values, level);
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      const std::size_t i = n % static_cast<std::size_t>(size.x);
      const std::size_t j = n / static_cast<std::size_t>(size.x);
      const double distance = values[n] >= level ? distances.at(n) : -distances.at(n);
      all[slice * along + i * alongU + j * alongV] =
        static_cast<float>(std::isnan(values[n]) ? values[n] : distance);
    }
  };
  const bool finished = parallelFor(static_cast<std::size_t>(dimensions[slices.axis]), measure, progress);
  return finished ? all : std::vector<float>();
}

#define INK_INSTANTIATE(T)                                                                                   \
  template std::vector<float> sliceDistances(                                                                \
    const GridField<T>&, double, bool, const ThickSlices&, const Progress&);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
