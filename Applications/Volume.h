#pragma once

#include "Statistics/IsoValue.h"

#include <optional>
#include <string>

class vtkImageData;

namespace ink::cli
{

/// The iso-value that suits a volume of one component, see ink::suggestIsoValue.
std::optional<IsoSuggestion> suggestIsoValue(vtkImageData* image);

/// Least and greatest of the finite values of a volume of one component; the first is greater than the second
/// if there are none.
void finiteRange(vtkImageData* image, double range[2]);

/// How a suggestion was found, in a few words.
std::string methodText(const IsoSuggestion& suggestion);

} // namespace ink::cli
