// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSurfaceSamples_h
#define InkSurfaceSamples_h

#include "Core/Progress.h"
#include "InkMeshTriangles.h"
#include "PointSampling/PoissonDisk.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkPoints;
class vtkPolyData;

/// The distribution of samples, see vtkInkSurfaceSampler::MethodType.
enum class InkNoise
{
  White,
  Blue,
  Progressive
};

/// The parameters of vtkInkSurfaceSampler.
struct InkSampleRequest
{
  InkNoise Noise = InkNoise::Blue;
  bool ByRadius = false; ///< Radius sets the number of samples, not Count
  std::size_t Count = 0;
  double Radius = 0.0;
  double CoverageSlack = ink::defaultCoverageSlack;
  bool Priority = true;
  int Seed = 0;
  ink::Progress Progress;
};

/// Samples of a mesh as VTK arrays.
class InkSurfaceSamples
{
public:
  /// Empty when aborted by the progress.
  /// @param triangles kept as a reference
  /// @throws std::invalid_argument that says what is wrong with the mesh or the request
  InkSurfaceSamples(const InkMeshTriangles& triangles, const InkSampleRequest& request);

  vtkSmartPointer<vtkPoints> MakePoints(int type) const;
  vtkSmartPointer<vtkDataArray> MakeNormals() const;
  vtkSmartPointer<vtkDataArray> MakeRadius(int type) const;
  /// Of discs that are up to so many times as large as the covering ones, see ink::edgeOffsets. Null without
  /// sharp edges.
  vtkSmartPointer<vtkDataArray> MakeEdgeOffsets(double radii) const;
  /// See InkAddFaces.
  void AddFaces(vtkPolyData* mesh, vtkPolyData* output) const;

private:
  void CheckMemory(double count, InkNoise noise) const;

  const InkMeshTriangles& Triangles;
  ink::CumulativeArea Areas;
  std::vector<ink::SurfaceSample> Samples;
  double Cover = 0.0; ///< covering radius: discs of it leave no holes
};

#endif
