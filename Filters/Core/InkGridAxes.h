// SPDX-License-Identifier: BSD-3-Clause

// Where an image has its voxels that is made of a rectilinear or structured grid (InkImageOfGrid.h).
#ifndef InkGridAxes_h
#define InkGridAxes_h

#include "vtkSmartPointer.h"

#include <array>

class vtkDataArray;
class vtkDataSet;
class vtkRectilinearGrid;
class vtkStructuredGrid;

/// How many points a grid has along i, j and k; 0 of one that is neither.
std::array<int, 3> InkGridDimensions(vtkDataSet* grid);

/// Along x, y and z.
std::array<vtkDataArray*, 3> InkGridCoordinates(vtkRectilinearGrid* grid);

/// A structured grid whose rows lie along x, y and z as one that says so, without values; null if they do
/// not, or if anything of it is hidden.
vtkSmartPointer<vtkRectilinearGrid> InkAsRectilinear(vtkStructuredGrid* grid);

/// Where an image has its voxels along an axis.
struct InkGridAxis
{
  double First = 0.0;
  double Last = 0.0;
  double Count = 0.0;
  bool IsEven = false; ///< where the grid has its points

  double Step() const { return (this->Last - this->First) / (this->Count - 1.0); }
};
using InkGridAxes = std::array<InkGridAxis, 3>;

/// Those of evenly spaced coordinates, and others with voxels as large as the finer quarter of the steps.
/// @throws std::invalid_argument if coordinates rise here and fall there
InkGridAxes InkFindAxes(vtkRectilinearGrid* grid);

/// The same in as many voxels as help: see InkImageOfGrid.
/// @throws std::invalid_argument if coordinates rise here and fall there, or are not finite
InkGridAxes InkFindVoxels(vtkDataSet* grid);

#endif
