// SPDX-License-Identifier: BSD-3-Clause
/// What is chosen by the values of a whole image, and what values there are.
#ifndef InkVolumeValues_h
#define InkVolumeValues_h

#include "vtkInkFiltersSamplingModule.h" // for the export macro

#include "Core/Progress.h"
#include "IsoSurface/ActiveCells.h"
#include "Statistics/FiniteRange.h"
#include "Statistics/IsoValue.h"
#include "Statistics/NoiseEstimate.h"

#include <cstddef>
#include <string>
#include <vector>

class InkImageSlabs;
class vtkImageData;

/// The iso-values that suit the image's active scalars, of one component; see ink::suggestIsoValues.
VTKINKFILTERSSAMPLING_EXPORT std::vector<ink::IsoSuggestion> InkSuggestIsoValues(vtkImageData* image);

/// The same of an image whose slices are read a few at a time, two times or, to be smoothed, four.
/// @param progress is told how far it is; it cannot stop it
VTKINKFILTERSSAMPLING_EXPORT std::vector<ink::IsoSuggestion> InkSuggestIsoValues(
  InkImageSlabs& slabs, const ink::Progress& progress);

///@{
/// What values an image has, of its scalars of one component.
VTKINKFILTERSSAMPLING_EXPORT ink::FiniteRange InkFindFiniteRange(vtkImageData* image);
VTKINKFILTERSSAMPLING_EXPORT ink::FiniteRange InkFindFiniteRange(InkImageSlabs& slabs);
///@}

///@{
/// At most so many points lie in each layer of cells along z, see ink::boundActiveCells.
VTKINKFILTERSSAMPLING_EXPORT std::vector<std::size_t> InkBoundLayerPoints(
  vtkImageData* image, double isoValue, ink::CrossingRule rule);
VTKINKFILTERSSAMPLING_EXPORT std::vector<std::size_t> InkBoundLayerPoints(
  InkImageSlabs& slabs, double isoValue, ink::CrossingRule rule);
///@}

/// The smoothing that noise, gray levels and slices around an iso-surface ask for, as
/// vtkInkIsoSurfaceSampler::SetSmoothing takes it, of active scalars of one component; see
/// ink::suggestSmoothings.
VTKINKFILTERSSAMPLING_EXPORT ink::SuggestedSmoothing InkSuggestSmoothing(
  vtkImageData* image, double isoValue);

/// The same of an image whose slices are read a few at a time, ink::NoiseEstimate::slices or more.
/// @param progress is told how far it is; it cannot stop it
/// @throws std::invalid_argument if too few can be had at a time
VTKINKFILTERSSAMPLING_EXPORT ink::SuggestedSmoothing InkSuggestSmoothing(
  InkImageSlabs& slabs, double isoValue, const ink::Progress& progress);

///@{
/// Whether active scalars of one component lie above an iso-value on nearly all of the image's sides; see
/// ink::surroundsObject.
VTKINKFILTERSSAMPLING_EXPORT bool InkSurroundsObject(vtkImageData* image, double isoValue);
VTKINKFILTERSSAMPLING_EXPORT bool InkSurroundsObject(InkImageSlabs& slabs, double isoValue);
///@}

///@{
/// How long the box around an iso-surface is along its longest side, in world units, but for specks; see
/// ink::activeCellExtent. Of active scalars of one component; 0 if there is no surface.
VTKINKFILTERSSAMPLING_EXPORT double InkFindSurfaceLength(vtkImageData* image, double isoValue);
VTKINKFILTERSSAMPLING_EXPORT double InkFindSurfaceLength(InkImageSlabs& slabs, double isoValue);
///@}

/// At most so many points lie on an iso-surface, as vtkInkIsoSurfaceSampler makes them; see
/// ink::boundActiveCells. Of active scalars of one component.
VTKINKFILTERSSAMPLING_EXPORT double InkBoundSurfacePoints(vtkImageData* image, double isoValue);

/// What the surface at an iso-value is, in a few words: "the outermost clear boundary, keeps 12 % of the
/// volume".
VTKINKFILTERSSAMPLING_EXPORT std::string InkDescribe(const ink::IsoSuggestion& suggestion);

/// That the first of some iso-values was chosen, and which ones are next, and, where no boundary is clear at
/// it, what is drawn then: sentences without their dots.
/// @param suggestions one or more
VTKINKFILTERSSAMPLING_EXPORT std::vector<std::string> InkDescribeChoice(
  const std::vector<ink::IsoSuggestion>& suggestions);

#endif
