// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkOutsideRange_h
#define InkOutsideRange_h

#include "vtkInkFiltersCoreModule.h" // for the export macro

#include <span>
#include <string>

class vtkDataArray;

/// Why no surface at any of some iso-values passes between an image's voxels, for the user: that none is set,
/// or that all lie outside the range. Empty if one may.
/// @param least, greatest of the image's finite values; least is greater if there are none
/// @param made what there would be of the surface, "points"
VTKINKFILTERSCORE_EXPORT std::string InkDescribeOutside(
  std::span<const double> isoValues, double least, double greatest, const std::string& made);

/// The same with the range of an array's component.
VTKINKFILTERSCORE_EXPORT std::string InkDescribeOutside(
  std::span<const double> isoValues, vtkDataArray* scalars, int component, const std::string& made);

#endif
