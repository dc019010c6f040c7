// SPDX-License-Identifier: BSD-3-Clause

// Images that were enlarged by repeating their samples, as they were before.
#ifndef InkWithoutRepeats_h
#define InkWithoutRepeats_h

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

#endif
