// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "IsoSurface/ActiveCells.h"
#include "Statistics/FiniteRange.h"
#include "Statistics/IsoValue.h"

#include <vector>

class vtkImageData;

namespace ink::cli
{

class Progress;
class VolumeSlices;

/// The iso-values that suit a volume, see ink::suggestIsoValues. How far it is goes to the current step.
std::vector<IsoSuggestion> suggestIsoValues(VolumeSlices& volume, Progress& progress);

/// What values a volume has, or some slices of one.
FiniteRange findFiniteRange(VolumeSlices& volume);
FiniteRange findFiniteRange(vtkImageData* slices);

/// See ink::boundActiveCells.
std::vector<std::size_t> boundActiveCells(vtkImageData* slices, double isoValue, CrossingRule rule);

} // namespace ink::cli
