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
  /// Adds `FaceId`, `FacePoints`, `BarycentricCoordinates`, and for InkMoveSamples the field arrays
  /// `SampledMesh`, which identifies the mesh (its numbers of cells and points, and InkFacesHash), and
  /// `SampledMeshPoints`, the mesh's points.
  void AddFaces(vtkPolyData* mesh, vtkPolyData* output) const;

private:
  void CheckMemory(double count, InkNoise noise) const;

  const InkMeshTriangles& Triangles;
  ink::CumulativeArea Areas;
  std::vector<ink::SurfaceSample> Samples;
  double Cover = 0.0; ///< covering radius: discs of it leave no holes
};

/// The density array of that name. @throws std::invalid_argument if it does not fit
vtkDataArray* InkGetDensity(vtkPolyData* mesh, const char* name, int association);

/// A phrase with the numbers of negative values and NaNs; empty if there are none.
std::string InkDescribeUnusableDensity(vtkDataArray* density);

/// A hash of a mesh's connectivity, below 2^53 so that a double holds it.
double InkFacesHash(vtkPolyData* mesh);

/// Whether samples made with InkSurfaceSamples::AddFaces are of a mesh with the same faces.
bool InkAreSamplesOf(vtkPolyData* samples, vtkPolyData* mesh);

/// Removes the arrays that InkSurfaceSamples::AddFaces adds.
void InkRemoveFaces(vtkPolyData* samples);

/// Writes samples of one mesh, made with InkSurfaceSamples::AddFaces, with their arrays to `output`, moved to
/// the same barycentric coordinates on another mesh with the same faces. `Radius` grows with the stretch of
/// the surface around each sample, see ink::pointStretch.
/// @throws std::invalid_argument if the samples have no faces or if these do not fit the mesh
void InkMoveSamples(vtkPolyData* mesh, vtkPolyData* samples, bool normals, int type, vtkPolyData* output);

#endif
