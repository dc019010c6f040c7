// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkPointCloud_h
#define InkPointCloud_h

class vtkAlgorithm;
class vtkPointSet;
class vtkPolyData;

/// What is wanted of points.
struct InkPointCloudOptions
{
  bool Normals = true; ///< estimate them where there are none
  bool Radius = true;  ///< from the points' spacing where there is none
  bool Priority = true;
  bool Vertices = true;
  int Seed = 0;
};

/// Writes the points of `input` with all their point arrays to `output`, in the order of their priority, and
/// with what is missing. `output` stays empty when the algorithm is asked to stop.
/// @throws std::invalid_argument if an array that is needed has the wrong shape
void InkPreparePointCloud(
  vtkPointSet* input, const InkPointCloudOptions& options, vtkAlgorithm* algorithm, vtkPolyData* output);

#endif
