// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "IsoSurface/ActiveCells.h"
#include "Statistics/FiniteRange.h"
#include "Statistics/IsoValue.h"

#include <optional>
#include <string>
#include <vector>

class vtkImageData;

namespace ink::cli
{

class Progress;
class VolumeSlices;

/// The iso-value that suits a volume, see ink::suggestIsoValue. How far it is goes to the current step.
std::optional<IsoSuggestion> suggestIsoValue(VolumeSlices& volume, Progress& progress);

/// What values a volume has, or some slices of one.
FiniteRange findFiniteRange(VolumeSlices& volume);
FiniteRange findFiniteRange(vtkImageData* slices);

/// See ink::boundActiveCells.
std::vector<std::size_t> boundActiveCells(vtkImageData* slices, double isoValue, CrossingRule rule);

/// How a suggestion was found, in a few words.
std::string methodText(const IsoSuggestion& suggestion);

} // namespace ink::cli
