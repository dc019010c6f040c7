// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSurfaceStipples_h
#define InkSurfaceStipples_h

#include "Core/Progress.h"

#include "vtkType.h"

class vtkDataArray;
class vtkPolyData;

/// The parameters of vtkInkStippleGenerator for a mesh.
struct InkSurfaceStippleRequest
{
  vtkIdType Count = 0; ///< total number of stipples; 0: PerPolygon times the number of polygons
  int PerPolygon = 1;
  int Seed = 0;
  bool Doubles = false;           ///< whether points are double
  vtkDataArray* Colors = nullptr; ///< of the mesh's points or cells, passed on; may be null
  bool ColorsOfCells = false;
  ink::Progress Progress;
};

/// Writes the stipples of a mesh to an empty output, a list for each polygon, but lists of neighbors
/// (InkNeighborLists) on polygons too small for one; leaves it empty when aborted by the progress.
/// @throws std::invalid_argument that says what is wrong with the mesh or the request
void InkMakeSurfaceStipples(vtkPolyData* mesh, const InkSurfaceStippleRequest& request, vtkPolyData* output);

#endif
