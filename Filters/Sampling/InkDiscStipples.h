// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkDiscStipples_h
#define InkDiscStipples_h

#include "vtkInkFiltersSamplingModule.h" // for the export macro

#include "Core/Progress.h"

#include "vtkType.h"

class vtkDataArray;
class vtkPolyData;

/// The parameters of vtkInkStippleGenerator for points with normals and radii.
struct InkDiscStippleRequest
{
  vtkIdType Count = 0; ///< of stipples, about; 0: PerPoint times the number of points
  int PerPoint = 1;
  int Seed = 0;
  bool Doubles = false;           ///< whether stipples' coordinates are double
  vtkDataArray* Colors = nullptr; ///< of the points, passed on; may be null
  ink::Progress Progress;
};

/// Whether the points have `Normals` and `Radius`, and so cover a surface with discs.
VTKINKFILTERSSAMPLING_EXPORT bool InkHasDiscs(vtkPolyData* points);

/// An estimate of the area of the surface that the points' discs cover, see ink::areaOf.
double InkAreaOfDiscs(vtkPolyData* points);

/// Writes stipples on the discs to an empty output, lists of neighbors (InkNeighborLists) with the mean
/// normal of their discs; leaves it empty when aborted by the progress. Points that `vtkGhostType` marks as
/// hidden or duplicate have none, and neither have neighbors at one position with different normals.
/// @throws std::invalid_argument that says what is wrong with the points or the request
void InkMakeDiscStipples(vtkPolyData* points, const InkDiscStippleRequest& request, vtkPolyData* output);

#endif
