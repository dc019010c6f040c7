// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSampleFaces_h
#define InkSampleFaces_h

#include "InkMeshTriangles.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

class vtkPolyData;

/// Adds the faces that samples of a mesh lie on, `FaceId`, `FacePoints`, `BarycentricCoordinates`, and for
/// InkMoveSamples the field arrays `SampledMesh`, which identifies the mesh (its numbers of cells and points,
/// and a hash of its faces), and `SampledMeshPoints`, the mesh's points.
/// @param triangles those of the mesh
void InkAddFaces(const InkMeshTriangles& triangles, const std::vector<ink::SurfaceSample>& samples,
  vtkPolyData* mesh, vtkPolyData* output);

/// Whether samples with faces are of a mesh that has the same ones.
bool InkAreSamplesOf(vtkPolyData* samples, vtkPolyData* mesh);

/// Removes the arrays that InkAddFaces adds.
void InkRemoveFaces(vtkPolyData* samples);

/// Writes samples of one mesh with all their arrays to `output`, moved to the same barycentric coordinates on
/// another mesh with the same faces. `Radius` grows with the stretch of the surface around each sample, see
/// ink::pointStretch; `EdgeOffsets` turn and stretch with its triangle.
/// @throws std::invalid_argument if the samples have no faces or if these do not fit the mesh
void InkMoveSamples(vtkPolyData* mesh, vtkPolyData* samples, bool normals, int type, vtkPolyData* output);

#endif
