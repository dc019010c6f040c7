// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Grid/GridField.h"
#include "IsoSurface/IsoThreshold.h"
#include "IsoSurface/MinMaxBricks.h"
#include "IsoSurface/SliceMasks.h"
#include "Simd/KernelDispatch.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

/// Internal to Common/IsoSurface.
namespace ink
{

/// One iso-value in the type of the samples.
template <class T>
struct Threshold
{
  IsoThreshold<T> atLeast;
  IsoThreshold<T> above;
};

/// Classifies the samples of a grid by several iso-values, a slice at a time, see SliceMasks. Rows are
/// processed in blocks of four. Blocks that MinMaxBricks show to be on one side of an iso-value are not read.
template <class T>
class SliceClassifier
{
public:
  using K = KernelScalar<T>;

  /// @param strict whether samples strictly above an iso-value are told, too
  /// @param beginRow, endRow the rows that are classified, rounded to whole blocks
  SliceClassifier(
    const GridField<T>& field, std::span<const double> isoValues, bool strict, int beginRow, int endRow)
    : Field(field)
    , Typed(kernelsFor<T>(samplingKernels()))
    , Strict(strict)
    , Samples(field.geometry().dimensions())
    , BeginRow(beginRow)
    , EndRow(endRow)
    , Words((this->Samples.x + WordBits - 1) / WordBits)
    , Blocks((this->Samples.y + Rows - 1) / Rows)
  {
    for (const double number : isoValues)
    {
      // An iso-value of NaN yields no active cells, like infinity: only missing samples are at or above it.
      const double isoValue = std::isnan(number) ? std::numeric_limits<double>::infinity() : number;
      this->Thresholds.push_back({ IsoThreshold<T>::atLeast(isoValue), IsoThreshold<T>::above(isoValue) });
    }
  }

  /// @param ranges to look up where they are of this grid; otherwise measured, if every sample `isRead`
  void use(MinMaxBricks* ranges, bool isRead)
  {
    this->Ranges = ranges && ranges->template fits<T>(this->Samples) ? ranges : nullptr;
    this->Measured = ranges && !this->Ranges && isRead ? ranges : nullptr;
    if (this->Measured)
    {
      this->Measured->template start<T>(this->Samples);
    }
  }
  bool measures() const { return this->Measured != nullptr; }

  int words() const { return this->Words; }   ///< of a row
  int blocks() const { return this->Blocks; } ///< of a slice
  std::size_t rowOffset(int j) const { return static_cast<std::size_t>(this->Words + 1) * j; }

  /// Masks of one slice for each iso-value, to classify samples into.
  std::vector<SliceMasks> makeMasks() const
  {
    const std::size_t words = this->rowOffset(Rows * this->Blocks + 1);
    return std::vector<SliceMasks>(this->Thresholds.size(), SliceMasks(words, this->Blocks, this->Strict));
  }

  /// The state of one thread.
  struct Scratch
  {
    std::vector<K> low;
    std::vector<K> high;
    std::vector<K> gathered;
    /// For the bricks of one layer: by threshold, with CrossingRule::Strict by its two bounds.
    std::vector<std::vector<std::uint8_t>> states;
    std::vector<std::vector<Side>> sides;
    int statesOf = -1; ///< their layer of bricks

    explicit Scratch(const SliceClassifier& classifier)
      : low(classifier.Measured ? classifier.Measured->counts().x : 0)
      , high(this->low.size())
      , gathered(classifier.Field.stride() == 1 ? 0 : static_cast<std::size_t>(Rows) * classifier.Samples.x)
    {
    }
  };

  /// @param k the slice
  /// @param measure whether its values belong to the bricks that are measured
  void classify(int k, bool measure, Scratch& scratch, std::vector<SliceMasks>& layers) const
  {
    if (this->Ranges)
    {
      this->judgeBricks(k / BrickWidth, scratch);
    }
    for (int block = this->BeginRow / Rows; block <= this->EndRow / Rows; ++block)
    {
      RowBlock<K> rows = {};
      for (std::size_t t = 0; t < layers.size(); ++t)
      {
        SliceMasks& layer = layers[t];
        layer.missing[block] = !this->Field.hidden().empty();
        if (Rows * block >= this->Samples.y)
        {
          continue;
        }
        if (this->Ranges && scratch.sides[t][block] != Side::Both)
        {
          layer.sides[block] = scratch.sides[t][block];
          layer.filled[block] = false;
          continue;
        }
        if (!rows.first)
        {
          rows = this->rowsOf(block, k, scratch);
        }
        this->classifyBlock(block, k, t, measure && t == 0, rows, scratch, layer);
      }
    }
  }

  /// Writes the bits of a block whose samples were not read.
  void fill(SliceMasks& layer, int block) const
  {
    if (Rows * block >= this->Samples.y || layer.filled[block])
    {
      return;
    }
    layer.filled[block] = true;
    const Word bits = layer.sides[block] == Side::Above ? ~Word(0) : Word(0);
    for (int j = Rows * block; j < std::min(Rows * (block + 1), this->Samples.y); ++j)
    {
      std::fill_n(&layer.above[this->rowOffset(j)], this->Words, bits);
      if (this->Strict)
      {
        std::fill_n(&layer.over[this->rowOffset(j)], this->Words, bits);
      }
    }
  }

private:
  /// One component of a block's rows.
  RowBlock<K> rowsOf(int block, int k, Scratch& scratch) const
  {
    const int j = Rows * block;
    const int rows = std::min(Rows, this->Samples.y - j);
    const std::size_t stride = this->Field.stride();
    const K* first =
      reinterpret_cast<const K*>(this->Field.data() + this->Field.geometry().offset({ 0, j, k }) * stride);
    if (stride == 1)
    {
      return { first, this->Samples.x, rows, this->Samples.x,
        static_cast<std::ptrdiff_t>(this->Samples.x) * this->Samples.y };
    }
    for (std::size_t n = 0; n < static_cast<std::size_t>(rows) * this->Samples.x; ++n)
    {
      scratch.gathered[n] = first[n * stride];
    }
    return { scratch.gathered.data(), this->Samples.x, rows, this->Samples.x, 0 };
  }

  void classifyBlock(int block, int k, std::size_t t, bool measure, const RowBlock<K>& rows, Scratch& scratch,
    SliceMasks& layer) const
  {
    const Threshold<T>& threshold = this->Thresholds[t];
    const std::size_t first = this->rowOffset(Rows * block);
    const std::ptrdiff_t reach = this->Words + 1;
    const auto bits = [&](const IsoThreshold<T>& bound, std::vector<Word>& words, bool strictly)
    {
      const K lowest = static_cast<K>(bound.lowest);
      int found = 0;
      if (this->Ranges)
      {
        const std::size_t bricks = static_cast<std::size_t>(this->Ranges->counts().x);
        const std::uint8_t* states = scratch.states[2 * t + strictly].data() + bricks * block;
        found = this->Typed.classifyMixed(rows, lowest, states, &words[first], reach);
      }
      else if (measure && !strictly && this->Measured)
      {
        found = this->Typed.classifyAndMeasure(
          rows, lowest, &words[first], reach, scratch.low.data(), scratch.high.data());
        this->keepRanges(block, k, scratch);
      }
      else
      {
        found = this->Typed.classify(rows, lowest, &words[first], reach);
      }
      if (!bound.reachable)
      {
        std::fill_n(&words[first], static_cast<std::size_t>(reach) * rows.rows, Word(0));
        found = (found & MaybeMissing) | SomeClear;
      }
      return found;
    };
    const int found = bits(threshold.atLeast, layer.above, false);
    layer.missing[block] |= (found & MaybeMissing) != 0;
    layer.filled[block] = true;
    layer.sides[block] = !(found & SomeSet) ? Side::Below : !(found & SomeClear) ? Side::Above : Side::Both;
    if (this->Strict)
    {
      const int strictly = bits(threshold.above, layer.over, true);
      // Samples at the iso-value are neither above nor below.
      if (layer.sides[block] == Side::Above && (strictly & SomeClear))
      {
        layer.sides[block] = Side::Both;
      }
    }
  }

  /// Merges the ranges measured in one layer of a block into its bricks.
  void keepRanges(int block, int k, Scratch& scratch) const
  {
    K* low = this->Measured->template low<K>(block, k / BrickWidth);
    K* high = this->Measured->template high<K>(block, k / BrickWidth);
    if (k % BrickWidth == 0)
    {
      std::copy(scratch.low.begin(), scratch.low.end(), low);
      std::copy(scratch.high.begin(), scratch.high.end(), high);
      return;
    }
    for (std::size_t b = 0; b < scratch.low.size(); ++b)
    {
      // NaN on either side is kept.
      low[b] = low[b] <= scratch.low[b] ? low[b] : (low[b] != low[b] ? low[b] : scratch.low[b]);
      high[b] = high[b] >= scratch.high[b] ? high[b] : (high[b] != high[b] ? high[b] : scratch.high[b]);
    }
  }

  /// Classifies one layer of bricks.
  void judgeBricks(int layer, Scratch& scratch) const
  {
    if (scratch.statesOf == layer)
    {
      return;
    }
    scratch.statesOf = layer;
    const int bricks = this->Ranges->counts().x;
    const std::size_t count = static_cast<std::size_t>(bricks) * this->Blocks;
    scratch.states.resize(2 * this->Thresholds.size());
    scratch.sides.resize(this->Thresholds.size());
    for (std::size_t t = 0; t < this->Thresholds.size(); ++t)
    {
      scratch.sides[t].resize(this->Blocks);
      const auto judge = [&](const IsoThreshold<T>& bound, bool strictly, int block)
      {
        std::vector<std::uint8_t>& states = scratch.states[2 * t + strictly];
        states.resize(count);
        std::uint8_t* own = states.data() + static_cast<std::size_t>(bricks) * block;
        if (!bound.reachable)
        {
          std::fill_n(own, bricks, std::uint8_t(0));
          return 0;
        }
        return this->Typed.judge(this->Ranges->template low<K>(block, layer),
          this->Ranges->template high<K>(block, layer), bricks, static_cast<K>(bound.lowest), own);
      };
      for (int block = 0; block < this->Blocks; ++block)
      {
        int side = judge(this->Thresholds[t].atLeast, false, block);
        if (this->Strict && judge(this->Thresholds[t].above, true, block) != 1 && side == 1)
        {
          side = 2;
        }
        scratch.sides[t][block] = static_cast<Side>(side);
      }
    }
  }

  const GridField<T>& Field;
  const TypedKernels<K>& Typed;
  bool Strict;
  glm::ivec3 Samples;
  int BeginRow;
  int EndRow;
  int Words;
  int Blocks;
  std::vector<Threshold<T>> Thresholds;
  MinMaxBricks* Ranges = nullptr;   ///< to look up
  MinMaxBricks* Measured = nullptr; ///< to fill in
};

} // namespace ink
