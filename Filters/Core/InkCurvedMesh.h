// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkCurvedMesh_h
#define InkCurvedMesh_h

#include "Core/Progress.h"
#include "vtkInkFiltersCoreModule.h" // for the export macro
#include "vtkSmartPointer.h"

class vtkPolyData;

/// A coarse mesh as the smooth surface that its point normals describe, those of one side at feature edges
/// (ink::curveMesh, InkWithFeatureNormals): of triangles alone, but those that lie where an earlier one does,
/// with a mesh's point data interpolated, its cell data repeated, point normals, and InkSourcePoints. The
/// mesh itself where its edges are short or straight, or where it has more than a million triangles.
/// @param progress when it asks to stop, the mesh is as far divided as it is
/// @throws std::invalid_argument as InkMeshTriangles does
VTKINKFILTERSCORE_EXPORT vtkSmartPointer<vtkPolyData> InkCurvedMesh(
  vtkPolyData* mesh, const ink::Progress& progress = {});

#endif
