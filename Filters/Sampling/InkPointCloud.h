// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkPointCloud_h
#define InkPointCloud_h

#include "vtkType.h"

class vtkAlgorithm;
class vtkPointSet;
class vtkPolyData;

/// What is wanted of points.
struct InkPointCloudOptions
{
  bool Normals = true; ///< estimate them where there are none
  int NormalNeighbors = 16;
  const double* Viewpoint = nullptr; ///< where estimated normals point to; null: outwards
  bool Radius = true;                ///< from the points' spacing where there is none
  bool UniformRadius = false;        ///< one for all points instead of each its own
  bool RemoveIsolated = false;       ///< leave out the points of no surface that radii are found not to have
  bool Priority = true;
  bool Vertices = true;
  int Seed = 0;
};

/// Writes the points of `input` with all their point arrays to `output`, in the order of their priority, and
/// with what is missing. Points that `vtkGhostType` marks as hidden or duplicate are left out. `output` stays
/// empty when the algorithm is asked to stop.
/// @return how many isolated points there are, see ink::PointRadii; 0 where radii are given or uniform
/// @throws std::invalid_argument if an array that is needed has the wrong shape
vtkIdType InkPreparePointCloud(
  vtkPointSet* input, const InkPointCloudOptions& options, vtkAlgorithm* algorithm, vtkPolyData* output);

#endif
