// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/BitCount.h"
#include "Fields/Grid/GridField.h"
#include "IsoSurface/ActiveCells.h"
#include "IsoSurface/MinMaxBricks.h"
#include "IsoSurface/SliceClassifier.h"
#include "IsoSurface/SliceMasks.h"
#include "Simd/KernelDispatch.h"

#include <glm/common.hpp>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

/// Internal to Common/IsoSurface.
namespace ink
{

/// The layers of cells per slab, a unit of parallel work; neighboring slabs both classify the layer of
/// samples between them. A multiple of a brick's.
constexpr int SlabLayers = 16;

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
  ActiveCellFinder(const GridField<T>& field, std::span<const double> isoValues, CrossingRule rule,
    const CellSelection& selection)
    : Field(field)
    , Kernels(samplingKernels())
    , Strict(rule == CrossingRule::Strict)
    , Skipped(selection.skipped)
    , Cells(glm::max(field.geometry().dimensions() - 1, glm::ivec3(0)))
    , Begin(glm::clamp(selection.begin, glm::ivec3(0), this->Cells))
    , End(glm::clamp(selection.end, glm::ivec3(0), this->Cells))
    , Classifier(field, isoValues, this->Strict, this->Begin.y, this->End.y)
  {
    for (int w = 0; w < this->Classifier.words(); ++w)
    {
      this->InRange.push_back(rangeBits(this->Begin.x, this->End.x, w * WordBits));
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

  /// See SliceClassifier::use.
  void use(MinMaxBricks* ranges) { this->Classifier.use(ranges, this->whole()); }
  bool measures() const { return this->Classifier.measures(); }

  /// The cells of a slab, for each iso-value.
  void find(int slab, std::span<ActiveCells> cells) const
  {
    const int begin = std::max(this->Begin.z, (this->firstSlab() + slab) * SlabLayers);
    const int end = std::min(this->End.z, (this->firstSlab() + slab + 1) * SlabLayers);
    Scratch scratch(this->Classifier);
    this->Classifier.classify(begin, true, scratch.samples, scratch.lower);
    for (int k = begin; k < end; ++k)
    {
      const bool measure = k + 1 < end || k + 1 == this->Cells.z;
      this->Classifier.classify(k + 1, measure, scratch.samples, scratch.upper);
      for (std::size_t t = 0; t < cells.size(); ++t)
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
    typename SliceClassifier<T>::Scratch samples;
    std::vector<SliceMasks> lower;
    std::vector<SliceMasks> upper;
    std::vector<Word> active; ///< cells of a block of rows

    explicit Scratch(const SliceClassifier<T>& classifier)
      : samples(classifier)
      , lower(classifier.makeMasks())
      , upper(classifier.makeMasks())
      , active(classifier.rowOffset(Rows))
    {
    }
  };

  std::size_t rowOffset(int j) const { return this->Classifier.rowOffset(j); }

  void findInLayer(
    int k, SliceMasks& lower, SliceMasks& upper, Scratch& scratch, ActiveCells::Slab& slab) const
  {
    for (int block = this->Begin.y / Rows; block * Rows < this->End.y; ++block)
    {
      const int next = block + 1 < this->Classifier.blocks() ? block + 1 : block;
      const Side side = lower.sides[block];
      if (side != Side::Both && lower.sides[next] == side && upper.sides[block] == side &&
        upper.sides[next] == side)
      {
        continue;
      }
      for (SliceMasks* layer : { &lower, &upper })
      {
        this->Classifier.fill(*layer, block);
        this->Classifier.fill(*layer, next);
      }
      const bool missing =
        lower.missing[block] || lower.missing[next] || upper.missing[block] || upper.missing[next];
      const int begin = Rows * block;
      const int end = std::min(begin + Rows, this->End.y);
      this->findInRows(begin, end, lower, upper, scratch);
      for (int j = std::max(begin, this->Begin.y); j < end; ++j)
      {
        this->keepCells(j, k, missing, &scratch.active[this->rowOffset(j - begin)], slab);
      }
    }
  }

  /// The active cells of some rows, to scratch.active.
  void findInRows(
    int begin, int end, const SliceMasks& lower, const SliceMasks& upper, Scratch& scratch) const
  {
    const int words = this->Classifier.words();
    if (!this->Strict)
    {
      const std::size_t first = this->rowOffset(begin);
      this->Kernels.activeRows(
        &lower.above[first], &upper.above[first], words + 1, end - begin, words, scratch.active.data());
      return;
    }
    for (int j = begin; j < end; ++j)
    {
      const std::size_t row = this->rowOffset(j);
      const std::size_t next = this->rowOffset(j + 1);
      for (int w = 0; w < words; ++w)
      {
        scratch.active[this->rowOffset(j - begin) + w] =
          activeStrict({ &lower.above[row], &lower.above[next], &upper.above[row], &upper.above[next] },
            { &lower.over[row], &lower.over[next], &upper.over[row], &upper.over[next] }, w);
      }
    }
  }

  void keepCells(int j, int k, bool missing, const Word* cells, ActiveCells::Slab& slab) const
  {
    const std::size_t room = slab.used + this->Classifier.words();
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
      Word active = cells[w] & inRange[w];
      if (oneByOne && active != 0)
      {
        active = this->withoutExceptions(active, missing, { w * WordBits, j, k });
      }
      // Written unconditionally, and kept if there are cells: cheaper than an unpredictable branch.
      *run = { active, { w * WordBits, j, k } };
      run += active != 0;
    }
    slab.used = static_cast<std::size_t>(run - slab.runs.data());
  }

  /// Removes cells that are skipped or have a missing corner.
  Word withoutExceptions(Word active, bool missing, const glm::ivec3& first) const
  {
    const std::size_t cell = first.x +
      static_cast<std::size_t>(this->Cells.x) * (first.y + static_cast<std::size_t>(this->Cells.y) * first.z);
    for (Word rest = active; rest != 0; rest &= rest - 1)
    {
      const int bit = std::countr_zero(rest);
      const bool skipped = (!this->Skipped.empty() && this->Skipped[cell + bit]) ||
        (missing && !this->hasCorners(first + glm::ivec3(bit, 0, 0)));
      active &= ~(Word(skipped) << bit);
    }
    return active;
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
  bool Strict;
  ElementMarks Skipped;
  glm::ivec3 Cells;
  glm::ivec3 Begin;
  glm::ivec3 End;
  SliceClassifier<T> Classifier;
  std::vector<Word> InRange; ///< the selection's cells in each word of a row
};

} // namespace ink
