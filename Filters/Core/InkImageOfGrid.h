// SPDX-License-Identifier: BSD-3-Clause

// Rectilinear and structured grids, as simulations write them, as images.
#ifndef InkImageOfGrid_h
#define InkImageOfGrid_h

#include "vtkInkFiltersCoreModule.h" // for the export macro
#include "vtkSmartPointer.h"

class vtkDataArray;
class vtkDataSet;
class vtkImageData;

struct InkGridImage
{
  vtkSmartPointer<vtkImageData> Image;
  bool IsResampled;
};

/// An image of a grid's values, which are its active scalars. A grid of evenly spaced points along x, y and z
/// is one as it is, with the values themselves, also where coordinates fall; others are resampled
/// (vtkResampleToImage), to float, or double where 4 bytes do not hold the type: an axis of evenly spaced
/// coordinates keeps them, another one has voxels as large as the finer quarter of its steps, a curvilinear
/// grid voxels a third as large as the finer quarter of its, unless these were more than 8 times as many as
/// the grid's points and more than 2 million (or 512 times as many), more than 134 million and than the
/// points, or lay within so many cells' bounding boxes that it would take minutes. Further outside of the
/// grid than the next voxel, and where its points or cells are hidden, values are NaN.
/// @param grid a vtkRectilinearGrid or vtkStructuredGrid of two points or more along each axis
/// @param values one for each point, or for each cell, of which each is then that of a point in the cell's
/// center; of several components the first one
/// @throws std::invalid_argument which says why there is no image: numbers of points or values, coordinates
/// that are not finite or rise here and fall there
VTKINKFILTERSCORE_EXPORT InkGridImage InkImageOfGrid(vtkDataSet* grid, vtkDataArray* values);

#endif
