// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkCutSides_h
#define InkCutSides_h

#include <array>

class vtkImageData;
class vtkPoints;

/// The share of each side of an image that points cover, 0 to 1: of 16 x 16 parts of the side, or as many as
/// it has voxels, those with a point that lies no more than half a voxel inside of it. Of a cap it is what
/// the image cuts, of a rim what that goes through.
/// @param image its structure alone @param points of which a million is looked at
/// @return the lower side along the image's first axis, the upper one, those along the second, and the third
std::array<double, 6> InkFindCutSides(vtkImageData* image, vtkPoints* points);

/// The same of the sides of the box around the points, along the image's axes: of a block, about 1. Nothing
/// where they lie within a voxel.
std::array<double, 6> InkFindFlatSides(vtkImageData* image, vtkPoints* points);

#endif
