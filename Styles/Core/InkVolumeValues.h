// SPDX-License-Identifier: BSD-3-Clause
/// What a style chooses by the values of a whole image.
#ifndef InkVolumeValues_h
#define InkVolumeValues_h

#include "vtkInkStylesModule.h" // for the export macro

#include "Statistics/IsoValue.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;

/// A point array of the image: the active scalars without a name; null if there is none.
VTKINKSTYLES_EXPORT vtkDataArray* InkFindScalars(vtkImageData* image, const std::string& array);

/// The iso-values that suit a point array of the image, of one component; see ink::suggestIsoValues.
/// @param array its name; empty: the active scalars
VTKINKSTYLES_EXPORT std::vector<ink::IsoSuggestion> InkSuggestIsoValues(
  vtkImageData* image, const std::string& array = {});

/// The smoothing that noise, gray levels and slices around an iso-surface ask for, as
/// vtkInkIsoSurfaceSampler::SetSmoothing takes it; see ink::suggestSmoothing.
/// @param array a point array of one component; empty: the active scalars
VTKINKSTYLES_EXPORT double InkSuggestSmoothing(
  vtkImageData* image, const std::string& array, double isoValue);

/// At most so many points lie on an iso-surface, as vtkInkIsoSurfaceSampler makes them; see
/// ink::boundActiveCells.
/// @param array a point array of one component; empty: the active scalars
VTKINKSTYLES_EXPORT double InkBoundSurfacePoints(
  vtkImageData* image, const std::string& array, double isoValue);

/// What the surface at an iso-value is, in a few words: "the outermost clear boundary, keeps 12 % of the
/// volume".
VTKINKSTYLES_EXPORT std::string InkDescribe(const ink::IsoSuggestion& suggestion);

/// That the first of some iso-values was chosen, and which ones are next, in a sentence without its dot.
/// @param suggestions one or more
VTKINKSTYLES_EXPORT std::string InkDescribeChoice(const std::vector<ink::IsoSuggestion>& suggestions);

#endif
