// SPDX-License-Identifier: BSD-3-Clause
/// What a style chooses by the values of a whole image.
#ifndef InkVolumeValues_h
#define InkVolumeValues_h

#include "vtkInkStylesModule.h" // for the export macro

#include "Statistics/IsoValue.h"

#include <optional>
#include <string>

class vtkImageData;

/// The iso-value that suits a point array of the image, of one component; see ink::suggestIsoValue.
/// @param array its name; empty: the active scalars
VTKINKSTYLES_EXPORT std::optional<ink::IsoSuggestion> InkSuggestIsoValue(
  vtkImageData* image, const std::string& array = {});

/// The smoothing that noise, grey levels and slices around an iso-surface ask for, as
/// vtkInkIsoSurfaceSampler::SetSmoothing takes it; see ink::suggestSmoothing.
/// @param array a point array of one component; empty: the active scalars
VTKINKSTYLES_EXPORT double InkSuggestSmoothing(
  vtkImageData* image, const std::string& array, double isoValue);

/// How an iso-value was found, in a few words.
VTKINKSTYLES_EXPORT std::string InkNameOfMethod(ink::IsoSuggestion::Method method);

/// A number as people write it: up to 7 significant digits.
VTKINKSTYLES_EXPORT std::string InkFormatShort(double number);

#endif
