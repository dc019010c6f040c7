// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkAddCuts_h
#define InkAddCuts_h

#include "IsoSurface/CutSamples.h"

#include <cstddef>
#include <span>
#include <vector>

class vtkDataArray;

/// The arrays of an iso-surface's samples, which have a tuple for each.
struct InkSampleArrays
{
  vtkDataArray* Points;
  vtkDataArray* Normals; ///< of floats, or of integers that 1 is the largest of; or null
  vtkDataArray* Cells;   ///< of ink::ActiveCellId, or null

  std::vector<vtkDataArray*> All() const;
};

/// Adds the samples of each surface's cut after its own.
///
/// @param cuts one for each surface
/// @param counts the number of samples of each surface, one surface after the other; those with its cut are
///   returned in it
void InkAddCuts(
  std::span<const ink::CutSamples> cuts, const InkSampleArrays& arrays, std::vector<std::size_t>& counts);

#endif
