// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Derivatives/LaplacianPlan.h"
#include "Fields/Derivatives/LaplacianRows.h"
#include "Fields/Derivatives/MaskedRowFilter.h"
#include "Fields/Derivatives/SeparableKernel.h"
#include "Fields/Grid/GridField.h"
#include "Fields/Grid/RowReader.h"
#include "Fields/SampleBox.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <type_traits>
#include <vector>

/// Internal to Common/Fields: the three passes of ink::laplacianOfGaussian.
namespace ink
{

/// The three passes over a tile, slice by slice.
template <class T>
class LaplacianPasses
{
public:
  /// Intermediate results per row: smoothed values, second derivatives, and those that mixed derivatives
  /// need.
  static constexpr int kinds = 3;

  LaplacianPasses(const LaplacianPlan<T>& plan, const SampleBox& tile)
    : P(plan)
    , Tile(tile)
    , ReadBegin(std::max(0, tile.begin.x - P.reach.x))
    , FirstRow(std::max(0, tile.begin.y - P.reach.y))
    , LastRow(std::min(P.dimensions.y, tile.end.y + P.reach.y))
    , Ring(2 * P.reach.z + 1)
    , TileHeight(tile.end.y - tile.begin.y)
    , Width(static_cast<std::size_t>(tile.end.x - tile.begin.x))
    , Read(static_cast<std::size_t>(std::min(P.dimensions.x, tile.end.x + P.reach.x) - ReadBegin))
    , ReadMarks(Read.size())
    , AlongX(static_cast<std::size_t>(LastRow - FirstRow), Width)
    , AlongY(static_cast<std::size_t>(Ring) * TileHeight, Width)
    , Sum(Width)
    , SumMissing(Width)
  {
  }

  /// Calls use(j, k, row) with each row of results, whose first is that of sample (tile.begin.x, j, k).
  template <class Use>
  void run(const Use& use)
  {
    int next = std::max(0, this->Tile.begin.z - this->P.reach.z);
    for (int k = this->Tile.begin.z; k < this->Tile.end.z; ++k)
    {
      for (; next < std::min(this->P.dimensions.z, k + this->P.reach.z + 1); ++next)
      {
        for (int j = this->FirstRow; j < this->LastRow; ++j)
        {
          this->passX(j, next);
        }
        for (int j = this->Tile.begin.y; j < this->Tile.end.y; ++j)
        {
          this->passY(j, next);
        }
      }
      for (int j = this->Tile.begin.y; j < this->Tile.end.y; ++j)
      {
        this->passZ(j, k);
        use(j, k, this->Sum);
      }
    }
  }

private:
  /// Rows of intermediate results, all of one width.
  struct Rows
  {
    std::size_t width;
    std::vector<double> values;
    std::vector<std::uint8_t> missing;
    std::unique_ptr<bool[]> marked;

    Rows(std::size_t rows, std::size_t rowWidth)
      : width(rowWidth)
      , values(rows * kinds * rowWidth)
      , missing(rows * rowWidth)
      , marked(std::make_unique<bool[]>(rows))
    {
    }
    Row row(std::size_t n, int kind)
    {
      return { this->values.data() + (n * kinds + kind) * this->width, this->missing.data() + n * this->width,
        &this->marked[n] };
    }
  };

  void passX(int j, int k)
  {
    const bool odd = readRow<T, double>(this->P.field, j, k, this->ReadBegin,
      std::numeric_limits<double>::infinity(), this->Read, this->ReadMarks);
    if constexpr (std::is_same_v<T, double>)
    {
      for (double& value : this->Read)
      {
        value *= laplacianScale<T>;
      }
    }
    const std::size_t n = static_cast<std::size_t>(j - this->FirstRow);
    Row out[kinds] = { this->AlongX.row(n, 0), this->AlongX.row(n, 1), this->AlongX.row(n, 2) };
    *out[0].marked = false;
    const int begin = this->Tile.begin.x;
    const int end = this->Tile.end.x;
    const int reach = this->P.reach.x;
    const int from = std::clamp(reach, begin, end);
    const int to = std::clamp(this->P.dimensions.x - reach, from, end);
    const auto useX = [&](const SeparableKernel& kernel, int i)
    {
      // As across rows: relative to the sample itself.
      const double* const samples = this->Read.data() + (i - this->ReadBegin);
      double smooth = 0.0;
      double first = 0.0;
      double second = 0.0;
      for (int offset = -reach; offset <= reach; ++offset)
      {
        if (kernel.smooth[offset + reach] != 0.0 || kernel.second[offset + reach] != 0.0 ||
          kernel.first[offset + reach] != 0.0)
        {
          const double d = samples[offset] - samples[0];
          smooth += kernel.smooth[offset + reach] * d;
          first += kernel.first[offset + reach] * d;
          second += kernel.second[offset + reach] * d;
        }
      }
      out[0].values[i - begin] = samples[0] + smooth;
      out[1].values[i - begin] = this->P.factors.straight.x * second;
      out[2].values[i - begin] = first;
    };
    for (int i = begin; i < from; ++i)
    {
      useX(this->P.x.kernels[i], i);
    }
    this->insideX(from, to, out);
    for (int i = to; i < end; ++i)
    {
      useX(this->P.x.kernels[i], i);
    }
    if (odd)
    {
      this->repairX(out, useX);
    }
  }

  void insideX(int from, int to, Row (&out)[kinds])
  {
    const std::size_t count = static_cast<std::size_t>(to - from);
    if (count == 0)
    {
      return;
    }
    const MirroredLine& line = this->P.x.inside;
    const double* const samples = this->Read.data() + (from - this->ReadBegin);
    const std::size_t at = static_cast<std::size_t>(from - this->Tile.begin.x);
    this->Pairs.middle = samples;
    this->Pairs.before.clear();
    this->Pairs.after.clear();
    for (std::size_t n = 1; n <= line.smooth.size(); ++n)
    {
      this->Pairs.before.push_back(samples - n);
      this->Pairs.after.push_back(samples + n);
    }
    smoothAndBend(this->Pairs, line.smooth, line.second, count, out[0].values + at, out[1].values + at);
    if (this->P.mixed)
    {
      std::fill_n(out[2].values + at, count, 0.0);
      addSlope(this->Pairs, line.first, count, out[2].values + at);
    }
  }

  /// Fits the samples that exist around missing ones. Where these are too few the result is missing.
  template <class UseX>
  void repairX(Row (&out)[kinds], const UseX& useX)
  {
    const int reach = this->P.reach.x;
    const int begin = this->Tile.begin.x;
    std::vector<std::uint8_t> used(2 * reach + 1);
    for (int i = begin; i < this->Tile.end.x; ++i)
    {
      bool all = true;
      for (int offset = -reach; offset <= reach; ++offset)
      {
        const bool onGrid = i + offset >= 0 && i + offset < this->P.dimensions.x;
        used[offset + reach] = onGrid && this->ReadMarks[i + offset - this->ReadBegin] != Missing;
        all = all && used[offset + reach] == onGrid;
      }
      out[0].missing[i - begin] = 0;
      if (all)
      {
        continue;
      }
      const SeparableKernel kernel(this->P.x.kernels.deviation(), used);
      out[0].missing[i - begin] = !kernel.exists;
      *out[0].marked = *out[0].marked || !kernel.exists;
      double& middle = this->Read[i - this->ReadBegin];
      const double kept = middle;
      if (kernel.exists && !used[reach])
      {
        // A missing sample is 0 in the row: differences from it would lose precision.
        const auto there = std::find(used.begin(), used.end(), 1) - used.begin();
        middle = this->Read[i - this->ReadBegin + there - reach];
      }
      useX(kernel, i);
      middle = kept;
    }
  }

  void passY(int j, int k)
  {
    const LinePlan& plan = this->P.y;
    this->gatherLines(plan.kernels.reach(), j, this->P.dimensions.y,
      [&](int row, int kind)
      { return this->AlongX.row(static_cast<std::size_t>(row - this->FirstRow), kind); });
    const std::size_t n = this->ringRow(j, k);
    Row out[kinds] = { this->AlongY.row(n, 0), this->AlongY.row(n, 1), this->AlongY.row(n, 2) };
    const LaplacianFactors& factors = this->P.factors;
    const std::size_t count = this->Width;
    double* const smooth = out[0].values;
    double* const curve = out[1].values;
    double* const mixed = out[2].values;
    if (plan.isInside(j))
    {
      smoothAndBend(this->pairsOf(0, plan), plan.inside.smooth, plan.inside.second, count, smooth, curve);
      addSmooth(this->pairsOf(1, plan), plan.inside.smooth, count, curve);
    }
    else
    {
      const SeparableKernel& kernel = plan.kernels[j];
      std::fill_n(smooth, count, 0.0);
      std::fill_n(curve, count, 0.0);
      addAcross(this->Lines[0], kernel, Derivative::None, 1.0, count, smooth);
      addAcross(this->Lines[0], kernel, Derivative::Second, factors.straight.y, count, curve);
      addAcross(this->Lines[1], kernel, Derivative::None, 1.0, count, curve);
    }
    if (this->P.mixed)
    {
      const SeparableKernel& kernel = plan.kernels[j];
      std::fill_n(mixed, count, 0.0);
      addAcross(this->Lines[2], kernel, Derivative::First, factors.xy, count, curve);
      addAcross(this->Lines[2], kernel, Derivative::None, factors.xz, count, mixed);
      addAcross(this->Lines[0], kernel, Derivative::First, factors.yz, count, mixed);
    }
    *out[0].marked = false;
    this->repairAcross(this->Lines[0], plan.kernels, out[0],
      [&](const SeparableKernel& part, std::size_t i)
      {
        smooth[i] = acrossAt(this->Lines[0], part, Derivative::None, i);
        curve[i] = acrossAt(this->Lines[1], part, Derivative::None, i) +
          factors.straight.y * acrossAt(this->Lines[0], part, Derivative::Second, i) +
          factors.xy * acrossAt(this->Lines[2], part, Derivative::First, i);
        mixed[i] = factors.xz * acrossAt(this->Lines[2], part, Derivative::None, i) +
          factors.yz * acrossAt(this->Lines[0], part, Derivative::First, i);
      });
  }

  void passZ(int j, int k)
  {
    const LinePlan& plan = this->P.z;
    this->gatherLines(plan.kernels.reach(), k, this->P.dimensions.z,
      [&](int slice, int kind) { return this->AlongY.row(this->ringRow(j, slice), kind); });
    const std::size_t count = this->Width;
    const double factor = this->P.factors.straight.z;
    std::vector<double>& sum = this->Sum;
    std::fill_n(sum.data(), count, 0.0);
    if (plan.isInside(k))
    {
      addSmooth(this->pairsOf(1, plan), plan.inside.smooth, count, sum.data());
      addBend(this->pairsOf(0, plan), plan.inside.second, count, sum.data());
    }
    else
    {
      addAcross(this->Lines[1], plan.kernels[k], Derivative::None, 1.0, count, sum.data());
      addAcross(this->Lines[0], plan.kernels[k], Derivative::Second, factor, count, sum.data());
    }
    if (this->P.mixed)
    {
      addAcross(this->Lines[2], plan.kernels[k], Derivative::First, 1.0, count, sum.data());
    }
    bool marked = false;
    this->repairAcross(this->Lines[0], plan.kernels, { sum.data(), this->SumMissing.data(), &marked },
      [&](const SeparableKernel& part, std::size_t i)
      {
        sum[i] = acrossAt(this->Lines[1], part, Derivative::None, i) +
          factor * acrossAt(this->Lines[0], part, Derivative::Second, i) +
          acrossAt(this->Lines[2], part, Derivative::First, i);
      });
  }

  /// The rows around one along y or z, those beyond the grid null.
  template <class RowAt>
  void gatherLines(int reach, int middle, int dimension, const RowAt& rowAt)
  {
    for (int kind = 0; kind < kinds; ++kind)
    {
      this->Lines[kind].rows.clear();
      for (int n = middle - reach; n <= middle + reach; ++n)
      {
        this->Lines[kind].rows.push_back(n >= 0 && n < dimension ? rowAt(n, kind) : Row{});
      }
    }
  }

  /// The rows of a line all of which are there.
  const RowPairs& pairsOf(int kind, const LinePlan& plan)
  {
    const std::vector<Row>& rows = this->Lines[kind].rows;
    const std::size_t middle = rows.size() / 2;
    this->Pairs.middle = rows[middle].values;
    this->Pairs.before.clear();
    this->Pairs.after.clear();
    for (std::size_t n = 1; n <= plan.inside.smooth.size(); ++n)
    {
      this->Pairs.before.push_back(rows[middle - n].values);
      this->Pairs.after.push_back(rows[middle + n].values);
    }
    return this->Pairs;
  }

  /// Calls fit(kernel, i) for the samples that some rows miss, with the kernel of the others.
  template <class Fit>
  void repairAcross(const Line& line, const SeparableKernels& kernels, const Row& out, const Fit& fit)
  {
    if (!line.anyMarked())
    {
      return;
    }
    std::vector<std::uint8_t> used(line.rows.size());
    for (std::size_t i = 0; i < this->Width; ++i)
    {
      bool all = true;
      for (std::size_t n = 0; n < line.rows.size(); ++n)
      {
        used[n] = !isMissing(line.rows[n], i);
        all = all && used[n] == (line.rows[n].values != nullptr);
      }
      out.missing[i] = 0;
      if (!all)
      {
        const SeparableKernel kernel(kernels.deviation(), used);
        out.missing[i] = !kernel.exists;
        *out.marked = *out.marked || !kernel.exists;
        fit(kernel, i);
      }
    }
  }

  std::size_t ringRow(int j, int k) const
  {
    return static_cast<std::size_t>(k % this->Ring) * this->TileHeight + (j - this->Tile.begin.y);
  }

  const LaplacianPlan<T>& P;
  SampleBox Tile;
  int ReadBegin;
  int FirstRow;
  int LastRow;
  int Ring;
  int TileHeight;
  std::size_t Width;
  std::vector<double> Read;
  std::vector<std::uint8_t> ReadMarks;
  Rows AlongX;
  Rows AlongY;
  std::vector<double> Sum;
  std::vector<std::uint8_t> SumMissing;
  /// Of the row that is worked on.
  Line Lines[kinds];
  RowPairs Pairs;
};

} // namespace ink
