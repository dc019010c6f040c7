// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Grid/ElementMarks.h"
#include "Fields/Grid/GridGeometry.h"
#include "Fields/SampleBox.h"

#include <glm/common.hpp>

namespace ink
{

/// The samples that a piece of a distributed volume owns: pieces overlap in ghost samples, but every sample
/// of the volume is owned by exactly one piece.
class PieceOwnership
{
public:
  /// @param others cells of the grid that other pieces own, one byte each: a sample belongs to the cell whose
  ///   lower corner it is, at the grid's upper end to the last cell
  PieceOwnership(const glm::ivec3& dimensions, const SampleBox& box, const ElementMarks& others = {})
    : Box{ glm::max(box.begin, glm::ivec3(0)), glm::min(box.end, dimensions) }
    , LastCell(glm::max(dimensions - 2, glm::ivec3(0)))
    , Cells(LastCell + 1)
    , Others(others)
  {
  }

  /// A box that contains all owned samples.
  const SampleBox& box() const { return this->Box; }
  /// Whether all samples of the box are owned.
  bool wholeBox() const { return this->Others.empty(); }
  /// @param sample a sample in the box
  bool has(const glm::ivec3& sample) const
  {
    return this->Others.empty() ||
      !this->Others[this->Cells.offset(glm::min(sample + this->First, this->LastCell))];
  }
  /// Of a part of the grid, which begins at sample `first`.
  /// @param box in samples of the part
  PieceOwnership ofPart(const glm::ivec3& first, const SampleBox& box) const
  {
    PieceOwnership part(*this);
    part.First += first;
    part.Box = box;
    return part;
  }

private:
  SampleBox Box;
  glm::ivec3 First = glm::ivec3(0); ///< where the samples are counted from
  glm::ivec3 LastCell;
  GridGeometry Cells;
  ElementMarks Others;
};

} // namespace ink
