// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkOutwardTriangles_h
#define InkOutwardTriangles_h

#include "InkMeshTriangles.h"
#include "InkPointNormals.h"
#include "Mesh/InsideOut.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <functional>

/// A mesh's triangles with its normals, or if it has none with computed ones, which point outwards.
inline InkMeshTriangles InkOutwardTriangles(
  vtkPolyData* mesh, InkMeshTriangles::Order order = InkMeshTriangles::Order::ByPosition)
{
  InkMeshTriangles triangles(mesh, true, order);
  if (!InkPointNormals(mesh) && ink::isInsideOut(triangles.GetMesh()))
  {
    std::transform(
      triangles.Normals.begin(), triangles.Normals.end(), triangles.Normals.begin(), std::negate<>());
  }
  return triangles;
}

#endif
