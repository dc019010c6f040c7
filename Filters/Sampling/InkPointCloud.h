// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkPointCloud_h
#define InkPointCloud_h

#include "vtkType.h"

class vtkAlgorithm;
class vtkPointSet;
class vtkPolyData;

/// What InkPreparePointCloud adds to points.
struct InkPointCloudOptions
{
  bool Normals = true; ///< estimate them if there are none
  int NormalNeighbors = 16;
  const double* Viewpoint = nullptr; ///< where estimated normals point to; null: outwards
  bool Radius = true;                ///< from the points' spacing if there is none
  bool UniformRadius = false;        ///< one for all points instead of one per point
  bool RemoveIsolated = false;       ///< leave out isolated points, for which no radius can be estimated
  bool Priority = true;
  bool Vertices = true;
  int Seed = 0;
};

/// Writes the points of `input` with all their point arrays to `output`, in the order of their priority, and
/// adds the missing ones. Points that `vtkGhostType` marks as hidden or duplicate are left out. `output`
/// stays empty when the algorithm is aborted.
/// @return the number of isolated points, see ink::PointRadii; 0 if radii are given or uniform
/// @throws std::invalid_argument if an array that is needed has the wrong shape
vtkIdType InkPreparePointCloud(
  vtkPointSet* input, const InkPointCloudOptions& options, vtkAlgorithm* algorithm, vtkPolyData* output);

#endif
