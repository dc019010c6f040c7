// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSubdivision_h
#define InkSubdivision_h

#include "vtkInkStylesModule.h" // for the export macro

#include <functional>
#include <limits>
#include <string>

class vtkInkStyle;

/// More points than this are not made of smaller cells: with what is made of them they take a gigabyte.
constexpr double InkMostDividedPoints = 16e6;

/// Into how many cells a voxel is divided along each axis.
struct InkSubdivision
{
  int Cells = 1;
  std::string Note; ///< why it is fewer than the picture asks for, without its dot; empty if it is not
  ///@{
  /// The sizes of pictures that ask for as many, see vtkInkStyle::GetRelativeSize: above one, up to the
  /// other.
  double Above = 0.0;
  double UpTo = std::numeric_limits<double>::infinity();
  ///@}
};

/// How many points take the place of one, at most, where voxels are divided into so many cells.
/// @param ratio the longest side of a voxel by its shortest one, up to which it is divided more
VTKINKSTYLES_EXPORT double InkGrowthOfPoints(int cells, double ratio);

/**
 * As many cells as make them a small part of the style's picture, whatever its pixels: 1, 2, 4 or 8, but not
 * so many that there are too many points, of which there are fewer where the style is interactive.
 * @param voxel the shortest side of any voxel, world units
 * @param ratio as for InkGrowthOfPoints
 * @param longest the longest side of the box around all voxels, world units
 * @param countPoints how many points are made of voxels that are not divided; called only where that matters
 */
VTKINKSTYLES_EXPORT InkSubdivision InkChooseSubdivision(vtkInkStyle* style, double voxel, double ratio,
  double longest, const std::function<double()>& countPoints, double mostPoints = InkMostDividedPoints);

#endif
