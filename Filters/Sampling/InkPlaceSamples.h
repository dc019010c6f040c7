// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkPlaceSamples_h
#define InkPlaceSamples_h

#include "Mesh/TriangleMesh.h"

#include "vtkSmartPointer.h"

#include <glm/vec3.hpp>

#include <vector>

class vtkFloatArray;
class vtkPoints;

/// Where samples of a mesh are. @param type VTK_DOUBLE, or any other for float
vtkSmartPointer<vtkPoints> InkPlacePoints(
  const ink::TriangleMesh& mesh, const std::vector<ink::SurfaceSample>& samples, int type);

/// The array `Normals` of samples. @param normals one per point of the mesh, or none: those of the triangles
vtkSmartPointer<vtkFloatArray> InkPlaceNormals(const ink::TriangleMesh& mesh,
  const std::vector<glm::vec3>& normals, const std::vector<ink::SurfaceSample>& samples);

#endif
