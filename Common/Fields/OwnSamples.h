#pragma once

#include "Fields/GridField.h"
#include "Fields/SampleBox.h"

#include <glm/common.hpp>

namespace ink
{

/// The samples of a grid that are one's own where others hold parts of the same volume, overlapping: each
/// sample of the volume is one part's own.
class OwnSamples
{
public:
  /// \param others cells of the grid, one byte each, that are others': a sample goes with the cell
  ///        whose lower corner it is, at the grid's upper end whose upper corner
  OwnSamples(const glm::ivec3& dimensions, const SampleBox& box, const ElementMarks& others = {})
    : Box{ glm::max(box.begin, glm::ivec3(0)), glm::min(box.end, dimensions) }
    , LastCell(glm::max(dimensions - 2, glm::ivec3(0)))
    , Cells(LastCell + 1)
    , Others(others)
  {
  }

  /// All that are one's own lie in it.
  const SampleBox& box() const { return this->Box; }
  /// Whether all of the box are.
  bool wholeBox() const { return this->Others.empty(); }
  /// \param sample in the box
  bool has(const glm::ivec3& sample) const
  {
    return this->Others.empty() || !this->Others[this->Cells.offset(glm::min(sample, this->LastCell))];
  }

private:
  SampleBox Box;
  glm::ivec3 LastCell;
  GridGeometry Cells;
  ElementMarks Others;
};

} // namespace ink
