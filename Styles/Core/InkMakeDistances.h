// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkMakeDistances_h
#define InkMakeDistances_h

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

class vtkImageData;

namespace ink
{
struct ThickSlices;
}

/// The samples of an image as distances from the contours that an iso-value has in its slices, as floats; see
/// ink::sliceDistances.
/// @param scalars of one component, contiguous
vtkSmartPointer<vtkDataArray> InkMakeDistances(
  vtkImageData* image, vtkDataArray* scalars, double isoValue, bool ofMask, const ink::ThickSlices& slices);

#endif
