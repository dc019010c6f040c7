// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/BitCount.h"
#include "Fields/Grid/GridField.h"
#include "IsoSurface/ActiveCells.h"
#include "IsoSurface/IsoThreshold.h"
#include "IsoSurface/MinMaxBricks.h"
#include "IsoSurface/SliceMasks.h"
#include "Simd/KernelDispatch.h"

#include <glm/common.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

/// Internal to Common/IsoSurface.
namespace ink
{

/// The layers of cells per slab, a unit of parallel work; neighboring slabs both classify the layer of
/// samples between them. A multiple of a brick's.
constexpr int SlabLayers = 16;

/// One iso-value in the type of the samples.
template <class T>
struct Threshold
{
  IsoThreshold<T> atLeast;
  IsoThreshold<T> above;
};

/// Finds active cells with bit masks: each sample of a row becomes one bit of `above`, 64 to a word, set if
/// the sample is at or above the iso-value. A cell is active if its eight corners are neither all set nor all
/// clear; for a row of cells these are four rows of bits and the same four shifted by one, so that a word
/// holds 64 cells. The rule CrossingRule::Strict also needs the samples strictly above the iso-value.
///
/// Rows are processed in blocks of four. A block is skipped if all its samples, and those of the next block
/// and the next layer, are on one side. With MinMaxBricks such blocks are not even read.
///
/// The masks treat NaN as below and infinity as a value. In blocks that may have missing samples, the corners
/// of the resulting active cells are then tested individually.
template <class T>
class ActiveCellFinder
{
public:
  using K = KernelScalar<T>;

  ActiveCellFinder(const GridField<T>& field, std::span<const double> isoValues, CrossingRule rule,
    const CellSelection& selection)
    : Field(field)
    , Kernels(samplingKernels())
    , Typed(typedKernelsOf<T>(this->Kernels))
    , Strict(rule == CrossingRule::Strict)
    , Skipped(selection.skipped)
    , Samples(field.geometry().dimensions())
    , Cells(glm::max(this->Samples - 1, glm::ivec3(0)))
    , Begin(glm::clamp(selection.begin, glm::ivec3(0), this->Cells))
    , End(glm::clamp(selection.end, glm::ivec3(0), this->Cells))
    , Words((this->Samples.x + WordBits - 1) / WordBits)
    , Blocks((this->Samples.y + Rows - 1) / Rows)
  {
    for (int w = 0; w < this->Words; ++w)
    {
      this->InRange.push_back(rangeBits(this->Begin.x, this->End.x, w * WordBits));
    }
    for (const double number : isoValues)
    {
      // An iso-value of NaN yields no active cells, like infinity: only missing samples are at or above it.
      const double isoValue = std::isnan(number) ? std::numeric_limits<double>::infinity() : number;
      this->Thresholds.push_back({ IsoThreshold<T>::atLeast(isoValue), IsoThreshold<T>::above(isoValue) });
    }
  }

  bool empty() const
  {
    return this->Begin.x >= this->End.x || this->Begin.y >= this->End.y || this->Begin.z >= this->End.z;
  }
  /// Whether all cells are selected, so that every sample is read and bricks can be measured.
  bool whole() const { return this->Begin == glm::ivec3(0) && this->End == this->Cells && !this->empty(); }

  /// Slabs begin at multiples of their thickness, so that bricks belong to one slab.
  int firstSlab() const { return this->Begin.z / SlabLayers; }
  int slabCount() const { return this->empty() ? 0 : (this->End.z - 1) / SlabLayers + 1 - this->firstSlab(); }

  void use(MinMaxBricks* ranges)
  {
    this->Ranges = ranges && ranges->template fits<T>(this->Samples) ? ranges : nullptr;
    this->Measured = ranges && !this->Ranges && this->whole() ? ranges : nullptr;
    if (this->Measured)
    {
      this->Measured->template start<T>(this->Samples);
    }
  }
  bool measures() const { return this->Measured != nullptr; }

  /// The cells of a slab, for each iso-value.
  void find(int slab, std::span<ActiveCells> cells) const
  {
    const int begin = std::max(this->Begin.z, (this->firstSlab() + slab) * SlabLayers);
    const int end = std::min(this->End.z, (this->firstSlab() + slab + 1) * SlabLayers);
    Scratch scratch(*this);
    for (std::size_t t = 0; t < this->Thresholds.size(); ++t)
    {
      const std::size_t words = this->rowOffset(Rows * this->Blocks + 1);
      scratch.lower.emplace_back(words, this->Blocks, this->Strict);
      scratch.upper.emplace_back(words, this->Blocks, this->Strict);
    }
    this->classify(begin, true, scratch, scratch.lower);
    for (int k = begin; k < end; ++k)
    {
      this->classify(k + 1, k + 1 < end || k + 1 == this->Cells.z, scratch, scratch.upper);
      for (std::size_t t = 0; t < this->Thresholds.size(); ++t)
      {
        this->findInLayer(k, scratch.lower[t], scratch.upper[t], scratch, cells[t].slabs[slab]);
      }
      std::swap(scratch.lower, scratch.upper);
    }
    for (ActiveCells& found : cells)
    {
      ActiveCells::Slab& own = found.slabs[slab];
      own.runs.resize(own.used);
      for (const CellRun& run : own.runs)
      {
        own.count += bitCount(run.cells);
      }
    }
  }

private:
  /// The state of one thread for one slab.
  struct Scratch
  {
    std::vector<SliceMasks> lower;
    std::vector<SliceMasks> upper;
    std::vector<Word> crossed;
    std::vector<K> low;
    std::vector<K> high;
    std::vector<K> gathered;
    /// For the bricks of one layer: by threshold, with CrossingRule::Strict by its two bounds.
    std::vector<std::vector<std::uint8_t>> states;
    std::vector<std::vector<Side>> sides;
    int statesOf = -1; ///< their layer of bricks

    explicit Scratch(const ActiveCellFinder& finder)
      : crossed(finder.rowOffset(Rows))
      , low(finder.Measured ? finder.Measured->counts().x : 0)
      , high(this->low.size())
      , gathered(finder.Field.stride() == 1 ? 0 : static_cast<std::size_t>(Rows) * finder.Samples.x)
    {
    }
  };

  std::size_t rowOffset(int j) const { return static_cast<std::size_t>(this->Words + 1) * j; }

  /// One component of a block's rows.
  SampleRows<K> rowsOf(int block, int k, Scratch& scratch) const
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

  void classify(int k, bool measure, Scratch& scratch, std::vector<SliceMasks>& layers) const
  {
    if (this->Ranges)
    {
      this->judgeBricks(k / BrickWidth, scratch);
    }
    // Only rows of the selection, rounded to whole blocks.
    for (int block = this->Begin.y / Rows; block <= this->End.y / Rows; ++block)
    {
      SampleRows<K> rows = {};
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

  void classifyBlock(int block, int k, std::size_t t, bool measure, const SampleRows<K>& rows,
    Scratch& scratch, SliceMasks& layer) const
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

  void findInLayer(
    int k, SliceMasks& lower, SliceMasks& upper, Scratch& scratch, ActiveCells::Slab& slab) const
  {
    for (int block = this->Begin.y / Rows; block * Rows < this->End.y; ++block)
    {
      const int next = block + 1 < this->Blocks ? block + 1 : block;
      const Side side = lower.sides[block];
      if (side != Side::Both && lower.sides[next] == side && upper.sides[block] == side &&
        upper.sides[next] == side)
      {
        continue;
      }
      for (SliceMasks* layer : { &lower, &upper })
      {
        this->fill(*layer, block);
        this->fill(*layer, next);
      }
      const bool missing =
        lower.missing[block] || lower.missing[next] || upper.missing[block] || upper.missing[next];
      const int begin = Rows * block;
      const int end = std::min(begin + Rows, this->End.y);
      this->cross(begin, end, lower, upper, scratch);
      for (int j = std::max(begin, this->Begin.y); j < end; ++j)
      {
        this->keepCells(j, k, missing, &scratch.crossed[this->rowOffset(j - begin)], slab);
      }
    }
  }

  /// The active cells of some rows, to scratch.crossed.
  void cross(int begin, int end, const SliceMasks& lower, const SliceMasks& upper, Scratch& scratch) const
  {
    if (!this->Strict)
    {
      const std::size_t first = this->rowOffset(begin);
      this->Kernels.activeRows(&lower.above[first], &upper.above[first], this->Words + 1, end - begin,
        this->Words, scratch.crossed.data());
      return;
    }
    for (int j = begin; j < end; ++j)
    {
      const std::size_t row = this->rowOffset(j);
      const std::size_t next = this->rowOffset(j + 1);
      for (int w = 0; w < this->Words; ++w)
      {
        scratch.crossed[this->rowOffset(j - begin) + w] =
          crossedStrict({ &lower.above[row], &lower.above[next], &upper.above[row], &upper.above[next] },
            { &lower.over[row], &lower.over[next], &upper.over[row], &upper.over[next] }, w);
      }
    }
  }

  void keepCells(int j, int k, bool missing, const Word* cells, ActiveCells::Slab& slab) const
  {
    const std::size_t room = slab.used + this->Words;
    if (slab.runs.size() < room)
    {
      slab.runs.resize(std::max<std::size_t>(2 * room, 1024));
    }
    const bool oneByOne = missing || !this->Skipped.empty();
    CellRun* run = slab.runs.data() + slab.used;
    const Word* inRange = this->InRange.data();
    const int end = (this->End.x + WordBits - 1) / WordBits;
    for (int w = this->Begin.x / WordBits; w < end; ++w)
    {
      Word crossed = cells[w] & inRange[w];
      if (oneByOne && crossed != 0)
      {
        crossed = this->withoutExceptions(crossed, missing, { w * WordBits, j, k });
      }
      // Written unconditionally, and kept if there are cells: cheaper than an unpredictable branch.
      *run = { crossed, { w * WordBits, j, k } };
      run += crossed != 0;
    }
    slab.used = static_cast<std::size_t>(run - slab.runs.data());
  }

  /// Removes cells that are skipped or have a missing corner.
  Word withoutExceptions(Word crossed, bool missing, const glm::ivec3& first) const
  {
    const std::size_t cell = first.x +
      static_cast<std::size_t>(this->Cells.x) * (first.y + static_cast<std::size_t>(this->Cells.y) * first.z);
    for (Word rest = crossed; rest != 0; rest &= rest - 1)
    {
      const int bit = std::countr_zero(rest);
      const bool skipped = (!this->Skipped.empty() && this->Skipped[cell + bit]) ||
        (missing && !this->hasCorners(first + glm::ivec3(bit, 0, 0)));
      crossed &= ~(Word(skipped) << bit);
    }
    return crossed;
  }

  bool hasCorners(const glm::ivec3& cell) const
  {
    for (int c = 0; c < 8; ++c)
    {
      if (!this->Field.has(cell + glm::ivec3(c & 1, c >> 1 & 1, c >> 2)))
      {
        return false;
      }
    }
    return true;
  }

  const GridField<T>& Field;
  const SamplingKernels& Kernels;
  const TypedKernels<K>& Typed;
  bool Strict;
  ElementMarks Skipped;
  glm::ivec3 Samples;
  glm::ivec3 Cells;
  glm::ivec3 Begin;
  glm::ivec3 End;
  int Words;
  int Blocks;
  std::vector<Word> InRange; ///< the selection's cells in each word of a row
  std::vector<Threshold<T>> Thresholds;
  MinMaxBricks* Ranges = nullptr;   ///< to look up
  MinMaxBricks* Measured = nullptr; ///< to fill in
};

} // namespace ink
