// SPDX-License-Identifier: BSD-3-Clause

// An image of some of another one's points.
#ifndef InkSubsample_h
#define InkSubsample_h

#include "vtkInkFiltersCoreModule.h" // for the export macro
#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkImageData;

/// Which points are taken along an axis, and where those stand that are made of them.
struct InkSubsampledAxis
{
  std::vector<int> Indices; ///< from 0, whatever the image's extent
  double First = 0.0;       ///< where the first one stands, in points of the image
  double Step = 1.0;        ///< how far apart they are
};

/// Takes them on all threads (vtkExtractVOI takes one), with all arrays of numbers that have as many as the
/// image has points, or cells; active scalars stay so. A cell is the one in the middle of those that it
/// covers.
VTKINKFILTERSCORE_EXPORT vtkSmartPointer<vtkImageData> InkSubsample(
  vtkImageData* image, const std::array<InkSubsampledAxis, 3>& axes);

#endif
