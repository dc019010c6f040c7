#pragma once

#include "Sampling/CrossedCells.h"
#include "Statistics/IsoValue.h"
#include "Statistics/ValueSummary.h"

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
ValueSummary summarizeValues(VolumeSlices& volume);
ValueSummary summarizeValues(vtkImageData* slices);

/// See ink::boundCrossedCells.
std::vector<std::size_t> boundCrossedCells(vtkImageData* slices, double isoValue, CrossingRule rule);

/// How a suggestion was found, in a few words.
std::string methodText(const IsoSuggestion& suggestion);

} // namespace ink::cli
