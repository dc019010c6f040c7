// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSurfaceSamples_h
#define InkSurfaceSamples_h

#include "InkMeshTriangles.h"
#include "Parallel/ParallelFor.h"
#include "Sampling/BlueNoise.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkPoints;
class vtkPolyData;

/// How samples are spread, see vtkInkSurfaceSampler::MethodType.
enum class InkNoise
{
  White,
  Blue,
  Progressive
};

/// What vtkInkSurfaceSampler is asked for.
struct InkSampleRequest
{
  InkNoise Noise = InkNoise::Blue;
  bool ByRadius = false; ///< Radius counts, not Count
  std::size_t Count = 0;
  double Radius = 0.0;
  double Gap = ink::defaultGap;
  bool Priority = true;
  int Seed = 0;
  ink::Progress Progress;
};

/// Samples of a mesh as VTK arrays.
class InkSurfaceSamples
{
public:
  /// Empty when the progress asks to stop.
  /// @param triangles kept as a reference
  /// @throws std::invalid_argument with what is wrong with the mesh or the request
  InkSurfaceSamples(const InkMeshTriangles& triangles, const InkSampleRequest& request);

  vtkSmartPointer<vtkPoints> MakePoints(int type) const;
  vtkSmartPointer<vtkDataArray> MakeNormals() const;
  vtkSmartPointer<vtkDataArray> MakeRadius(int type) const;
  /// Adds `FaceId`, `FacePoints`, `BarycentricCoordinates`, and for InkMoveSamples the field arrays
  /// `SampledMesh`, by which it knows the mesh again (how many cells and points it has, and InkFacesHash),
  /// and `SampledMeshPoints`, the mesh's points.
  void AddFaces(vtkPolyData* mesh, vtkPolyData* output) const;

private:
  void CheckMemory(double count, InkNoise noise) const;

  const InkMeshTriangles& Triangles;
  ink::CumulativeArea Areas;
  std::vector<ink::SurfaceSample> Samples;
  double Cover = 0.0; ///< radius of discs without holes
};

/// A density array by its name. @throws std::invalid_argument if it does not fit
vtkDataArray* InkGetDensity(vtkPolyData* mesh, const char* name, int association);

/// How many values are negative and how many NaN, in words; empty if there are none.
std::string InkDescribeUnusableDensity(vtkDataArray* density);

/// A number below 2^53 that says which points the faces of a mesh join, in which order.
double InkFacesHash(vtkPolyData* mesh);

/// Whether samples that InkSurfaceSamples::AddFaces made are of a mesh with the same faces.
bool InkAreSamplesOf(vtkPolyData* samples, vtkPolyData* mesh);

/// Takes the arrays away that InkSurfaceSamples::AddFaces adds.
void InkRemoveFaces(vtkPolyData* samples);

/// Writes samples that InkSurfaceSamples::AddFaces made for one mesh with their arrays to `output`, moved to
/// where another mesh of the same faces has them. `Radius` grows by how much the surface is stretched around
/// each sample, see ink::pointStretch.
/// @throws std::invalid_argument if the samples have no faces or if these do not fit the mesh
void InkMoveSamples(vtkPolyData* mesh, vtkPolyData* samples, bool normals, int type, vtkPolyData* output);

#endif
