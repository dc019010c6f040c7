// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSampleSlabs_h
#define InkSampleSlabs_h

#include "vtkInkIsoSurfaceAlgorithm.h"

#include "Core/Progress.h"
#include "Statistics/FiniteRange.h"

#include <span>

class InkImageSlabs;
class vtkInkIsoSurfaceSampler;
struct InkMemoryBudget;

/// Samples the iso-surfaces of an image a few slices at a time: the points of vtkInkIsoSurfaceSampler, of
/// which no more are made at a time than memory has room for.
/// @param settings whose properties count, but for iso-values and which parts of surfaces are left out
/// @param cellIds whether points have the array `CellId`
/// @return the range of the values of the image, or of the slices before it was stopped
/// @throws std::runtime_error if memory is not enough, or if the slices cannot be made
ink::FiniteRange InkSampleSlabs(InkImageSlabs& slabs, vtkInkIsoSurfaceSampler* settings,
  std::span<const double> isoValues, bool cellIds, const InkMemoryBudget& budget,
  const vtkInkIsoSurfaceAlgorithm::PartSink& sink, const ink::Progress& progress);

#endif
