// SPDX-License-Identifier: BSD-3-Clause
/**
 * Fewer points of an image, for surfaces that are made quickly.
 */
#ifndef vtkInkCoarseImage_h
#define vtkInkCoarseImage_h

#include "vtkSmartPointer.h" // for the result
#include "vtkType.h"         // for vtkIdType

class vtkImageData;

/**
 * Every point, or every second, third, ... along each axis, so that no more than `mostPoints` are left, which
 * are as evenly spaced as that goes. They stand where they do in the image, with all arrays of numbers. The
 * image itself where it has no more points.
 */
vtkSmartPointer<vtkImageData> vtkInkCoarseImage(vtkImageData* image, vtkIdType mostPoints);

#endif
