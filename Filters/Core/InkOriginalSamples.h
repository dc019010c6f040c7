// SPDX-License-Identifier: BSD-3-Clause

// Images that were enlarged, as they were before.
#ifndef InkOriginalSamples_h
#define InkOriginalSamples_h

#include "vtkInkFiltersCoreModule.h" // for the export macro
#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;

/// An image with one point for each block of equal ones (ink::findRepeatedSamples), in its middle; all its
/// other arrays have as many then.
/// @param array whose values are looked at; empty: the active scalars, or else the first
/// @return the image itself where no more than two are equal along each axis, and where it has arrays of
/// cells
VTKINKFILTERSCORE_EXPORT vtkSmartPointer<vtkImageData> InkWithoutRepeats(
  vtkImageData* image, const std::string& array = {});

/// An image with the slices alone that others were interpolated between (ink::findInterpolatedSlices), as
/// InkWithoutRepeats.
VTKINKFILTERSCORE_EXPORT vtkSmartPointer<vtkImageData> InkWithoutInterpolatedSlices(
  vtkImageData* image, const std::string& array = {});

#endif
