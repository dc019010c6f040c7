// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Grid/GridField.h"
#include "Fields/Grid/RowReader.h"
#include "Fields/Resampling/AxisResampling.h"
#include "Fields/Resampling/WeightedRows.h"
#include "Fields/SampleBox.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace ink
{

/// The resampling along x, y and z.
using GridResampling = std::array<AxisResampling, 3>;

/// Resamples boxes of a grid, one axis after the other: read() gets the samples that a box depends on, of
/// which resample() makes the values at the box's positions. Missing samples (hidden, NaN, infinite) do not
/// count, by normalized convolution (Knutsson and Westin, "Normalized and differential convolution", CVPR
/// 1993); where nearly all weight is theirs, values are NaN. A value depends on the samples around it, not on
/// the box, bitwise; where these are equal, it is equal to them. Work is float or double.
template <class Work>
class TileResampler
{
public:
  /// Reads what the positions of a box depend on.
  /// @param reach samples to read around; at least the resamplings'
  template <class T>
  void read(const GridField<T>& field, const SampleBox& positions, const glm::ivec3& subdivision,
    const glm::ivec3& reach)
  {
    this->Source.begin = glm::max(positions.begin / subdivision - reach, glm::ivec3(0));
    this->Source.end = glm::min((positions.end - 1) / subdivision + reach + 2, field.geometry().dimensions());
    const glm::ivec3 size = this->Source.size();
    const std::size_t width = static_cast<std::size_t>(size.x);
    this->Samples.resize(this->Source.count());
    this->Present.clear();
    this->Marks.resize(width);
    this->Least = std::numeric_limits<Work>::infinity();
    this->Greatest = -this->Least;
    for (int k = 0; k < size.z; ++k)
    {
      for (int j = 0; j < size.y; ++j)
      {
        const std::size_t first = width * (static_cast<std::size_t>(size.y) * k + j);
        const std::span<Work> row(this->Samples.data() + first, width);
        const bool marked = readRow<T, Work>(field, this->Source.begin.y + j, this->Source.begin.z + k,
          this->Source.begin.x, std::numeric_limits<Work>::infinity(), row, this->Marks);
        if (marked && std::count(this->Marks.begin(), this->Marks.end(), Missing) > 0)
        {
          this->addMissing(first, row);
          continue;
        }
        // Two numbers instead of std::minmax_element, so that compilers vectorize the loop.
        Work least = this->Least;
        Work greatest = this->Greatest;
        for (const Work value : row)
        {
          least = value < least ? value : least;
          greatest = value > greatest ? value : greatest;
        }
        this->Least = least;
        this->Greatest = greatest;
      }
    }
  }

  /// Of the samples that were read and are not missing; the least is greater if there are none.
  Work least() const { return this->Least; }
  Work greatest() const { return this->Greatest; }
  bool anyMissing() const { return !this->Present.empty(); }

  /// Multiplies all samples.
  void scale(Work factor)
  {
    for (Work& value : this->Samples)
    {
      value *= factor;
    }
  }

  /// Replaces all samples by 1, those at or above a value, and 0.
  void makeMask(double value)
  {
    std::swap(this->Samples, this->Labels);
    this->Samples.resize(this->Labels.size());
    for (std::size_t n = 0; n < this->Samples.size(); ++n)
    {
      if (!this->Present.empty() && this->Present[n] == Work(0))
      {
        this->Labels[n] = std::numeric_limits<Work>::quiet_NaN();
      }
      // Missing ones stay 0.
      this->Samples[n] = static_cast<double>(this->Labels[n]) >= value ? Work(1) : Work(0);
    }
  }

  /// The samples that were read.
  const SampleBox& source() const { return this->Source; }
  /// After makeMask: what the samples of a row were from one on; NaN where they are missing.
  const Work* labelsFrom(const glm::ivec3& sample) const
  {
    const glm::ivec3 at = sample - this->Source.begin;
    const glm::ivec3 size = this->Source.size();
    return this->Labels.data() + at.x +
      static_cast<std::size_t>(size.x) * (at.y + static_cast<std::size_t>(size.y) * at.z);
  }

  /// @param positions the box that was read
  /// @param values output: its values, x fastest
  void resample(const GridResampling& resampling, const SampleBox& positions, std::vector<Work>& values)
  {
    this->passes(this->Samples, resampling, positions, values);
    if (!this->anyMissing())
    {
      return;
    }
    this->passes(this->Present, resampling, positions, this->Weights);
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      // Exactly 1 where none is missing.
      const Work weight = this->Weights[n];
      values[n] = weight > leastWeight ? values[n] / weight : std::numeric_limits<Work>::quiet_NaN();
    }
  }

private:
  static constexpr Work leastWeight = Work(0.01);

  void addMissing(std::size_t first, std::span<const Work> row)
  {
    if (this->Present.empty())
    {
      this->Present.assign(this->Samples.size(), Work(1));
    }
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      if (this->Marks[i] == Missing)
      {
        this->Present[first + i] = Work(0);
      }
      else
      {
        this->Least = std::min(this->Least, row[i]);
        this->Greatest = std::max(this->Greatest, row[i]);
      }
    }
  }

  void passes(const std::vector<Work>& samples, const GridResampling& resampling, const SampleBox& positions,
    std::vector<Work>& values)
  {
    const glm::ivec3 from = this->Source.size();
    const glm::ivec3 to = positions.size();
    const std::size_t width = static_cast<std::size_t>(to.x);
    const auto rowOf = [width](std::vector<Work>& rows, int n)
    { return rows.data() + width * static_cast<std::size_t>(n); };

    const int rows = from.y * from.z;
    this->AlongX.resize(width * static_cast<std::size_t>(rows));
    this->prepareX(resampling[0], positions);
    for (int row = 0; row < rows; ++row)
    {
      this->passX(resampling[0], positions, samples.data() + static_cast<std::size_t>(row) * from.x,
        rowOf(this->AlongX, row), to.x);
    }
    this->AlongY.resize(width * static_cast<std::size_t>(to.y) * from.z);
    for (int k = 0; k < from.z; ++k)
    {
      this->passAcross(resampling[1], positions.begin.y, this->Source.begin.y, from.y, width,
        rowOf(this->AlongX, k * from.y), width, to.y, rowOf(this->AlongY, k * to.y));
    }
    // Whole slices at a time.
    values.resize(positions.count());
    const std::size_t slice = width * static_cast<std::size_t>(to.y);
    this->passAcross(resampling[2], positions.begin.z, this->Source.begin.z, from.z, slice,
      this->AlongY.data(), slice, to.z, values.data());
  }

  /// The weights along x, tap by tap for all positions of a row.
  void prepareX(const AxisResampling& axis, const SampleBox& positions)
  {
    const int count = positions.size().x;
    this->RowWeights.resize(static_cast<std::size_t>(axis.taps()) * count);
    for (int i = 0; i < count; ++i)
    {
      const std::span<const double> weights = axis.weights(positions.begin.x + i);
      for (int n = 0; n < axis.taps(); ++n)
      {
        this->RowWeights[static_cast<std::size_t>(n) * count + i] =
          static_cast<Work>(weights[static_cast<std::size_t>(n)]);
      }
    }
  }

  void passX(const AxisResampling& axis, const SampleBox& positions, const Work* from, Work* to, int count)
  {
    const int steps = axis.subdivision();
    const int last = this->Source.size().x - 1;
    int sample = positions.begin.x / steps - axis.reach() - this->Source.begin.x;
    const std::span<const double> weights = axis.weights(positions.begin.x);
    const bool allThere = sample >= 0 && sample + axis.taps() + count - 2 <= last;
    if (steps == 1 && allThere && weights.data() == axis.weights(positions.end.x - 1).data())
    {
      // The same weights everywhere.
      this->Rows.clear();
      this->AcrossWeights.clear();
      for (int n = 0; n < axis.taps(); ++n)
      {
        if (n != axis.reach())
        {
          this->Rows.push_back(from + sample + n);
          this->AcrossWeights.push_back(static_cast<Work>(weights[static_cast<std::size_t>(n)]));
        }
      }
      sumAcross(
        from + sample + axis.reach(), this->Rows, this->AcrossWeights, static_cast<std::size_t>(count), to);
      return;
    }
    // Each sample as often as it has positions, so that for each tap all positions read consecutive numbers.
    const int repeated = count + steps * (axis.taps() - 1);
    this->Repeated.resize(static_cast<std::size_t>(repeated));
    int left = steps - positions.begin.x % steps;
    for (Work& value : this->Repeated)
    {
      // Samples beyond the ends weigh nothing.
      value = from[std::clamp(sample, 0, last)];
      if (--left == 0)
      {
        left = steps;
        ++sample;
      }
    }
    sumAlong(this->Repeated.data(), steps, this->RowWeights.data(), axis.taps(), axis.reach(), count, to);
  }

  /// @param begin the first position; sourceBegin the first of `samples` rows
  void passAcross(const AxisResampling& axis, int begin, int sourceBegin, int samples, std::size_t reachOfRow,
    const Work* from, std::size_t width, int count, Work* to)
  {
    for (int p = begin; p < begin + count; ++p, to += width)
    {
      const std::span<const double> weights = axis.weights(p);
      const int first = p / axis.subdivision() - axis.reach() - sourceBegin;
      this->Rows.clear();
      this->AcrossWeights.clear();
      const Work* const middle = from + reachOfRow * static_cast<std::size_t>(first + axis.reach());
      for (int n = 0; n < axis.taps(); ++n)
      {
        if (n != axis.reach() && weights[static_cast<std::size_t>(n)] != 0.0 && first + n >= 0 &&
          first + n < samples)
        {
          this->Rows.push_back(from + reachOfRow * static_cast<std::size_t>(first + n));
          this->AcrossWeights.push_back(static_cast<Work>(weights[static_cast<std::size_t>(n)]));
        }
      }
      sumAcross(middle, this->Rows, this->AcrossWeights, width, to);
    }
  }

  SampleBox Source; ///< what was read
  Work Least = 0;
  Work Greatest = 0;
  std::vector<Work> Samples;
  std::vector<Work> Labels;  ///< what they were before makeMask
  std::vector<Work> Present; ///< 0 for missing samples, 1 for others; empty where none is missing
  std::vector<std::uint8_t> Marks;
  std::vector<Work> AlongX;
  std::vector<Work> AlongY;
  std::vector<Work> Weights;
  std::vector<Work> Repeated;
  std::vector<Work> RowWeights;
  std::vector<const Work*> Rows;
  std::vector<Work> AcrossWeights;
};

} // namespace ink
