// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSurfaceStipples_h
#define InkSurfaceStipples_h

#include "Parallel/ParallelFor.h"

#include "vtkType.h"

class vtkDataArray;
class vtkPolyData;

/// What vtkInkStippleGenerator is asked for when its input is a mesh.
struct InkSurfaceStippleRequest
{
  vtkIdType Count = 0; ///< of all stipples; 0: PerPolygon times the number of polygons
  int PerPolygon = 1;
  int Seed = 0;
  bool Doubles = false;           ///< the points' type
  vtkDataArray* Colors = nullptr; ///< of the mesh's points or cells, passed on; may be null
  bool ColorsOfCells = false;
  ink::Progress Progress;
};

/// Writes the stipples of a mesh to an empty output; leaves it empty when the progress asks to stop.
/// @throws std::invalid_argument with what is wrong with the mesh or the request
void InkMakeSurfaceStipples(vtkPolyData* mesh, const InkSurfaceStippleRequest& request, vtkPolyData* output);

#endif
