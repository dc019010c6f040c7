// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkMeshTriangles_h
#define InkMeshTriangles_h

#include "Sampling/TriangleMesh.h"

#include "vtkType.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;

/// What ink::TriangleMesh looks at, taken from a vtkPolyData: triangles as they are, other polygons and
/// strips cut into triangles by vtkTriangleFilter. Vertices and lines, and cells that are ghosts or hidden,
/// are left out. They come in an order by where they are (ink::orderByPosition), so that what is made of them
/// does not depend on how the mesh is numbered or was cut into pieces.
struct InkMeshTriangles
{
  std::vector<glm::dvec3> Points;
  std::vector<ink::Triangle> Triangles;
  std::vector<vtkIdType> FaceIds; ///< the cell of each triangle
  /// Of each triangle, the same in whatever piece of a mesh it is: from the cell's global id. Empty where
  /// there are no global ids.
  std::vector<std::uint64_t> Names;
  std::vector<glm::vec3> Normals; ///< unit, one a point
  std::vector<float> PointDensity;
  std::vector<float> FaceDensity; ///< one a triangle

  enum class Order
  {
    ByPosition,
    OfMesh ///< for what depends on no order
  };

  /// @param wantNormals the point normals, or where there are none the mean over the faces around each point
  /// @throws std::invalid_argument for a face with a point that does not exist, or for more of anything than
  /// 32 bits number
  InkMeshTriangles(vtkPolyData* mesh, bool wantNormals, Order order = Order::ByPosition);

  /// Takes an array of one value a point or a cell as relative density.
  void SetDensity(vtkDataArray* density, bool ofCells);

  ink::TriangleMesh GetMesh() const;

private:
  void SortByPosition();
};

#endif
