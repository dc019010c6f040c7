// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkMeshTriangles_h
#define InkMeshTriangles_h

#include "Mesh/TriangleMesh.h"

#include "vtkInkFiltersCoreModule.h" // for the export macro
#include "vtkType.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;

/// The arrays that an ink::TriangleMesh views, made from a vtkPolyData: triangles as they are, other polygons
/// and strips triangulated by vtkTriangleFilter. Vertices, lines, ghost cells and hidden cells are left out,
/// and so are triangles that lie where an earlier one does (ink::repeatedTriangles), as the second sides of
/// sheets in files that have both.
/// Triangles are sorted by position (ink::orderByPosition), so that results do not depend on the numbering of
/// the mesh or its partition into pieces.
struct VTKINKFILTERSCORE_EXPORT InkMeshTriangles
{
  std::vector<glm::dvec3> Points;
  std::vector<ink::Triangle> Triangles;
  std::vector<vtkIdType> FaceIds; ///< the cell of each triangle
  /// An id per triangle that does not depend on the piece it is in: from the cell's global id. Empty without
  /// global ids.
  std::vector<std::uint64_t> Names;
  std::vector<glm::vec3> Normals; ///< unit, one per point
  std::vector<float> PointDensity;
  std::vector<float> FaceDensity; ///< one per triangle

  enum class Order
  {
    ByPosition,
    OfMesh ///< for results that do not depend on the order
  };

  enum class Repeats
  {
    LeftOut,
    Kept ///< for results at points, which the sides of a sheet may not share
  };

  /// @param wantNormals fills Normals: the point normals, or if there are none the mean over the faces around
  ///   each point
  /// @throws std::invalid_argument for a face with a point that does not exist, for faces none of which has
  ///   finite points only, or for more points or triangles than 32-bit ids allow
  InkMeshTriangles(
    vtkPolyData* mesh, bool wantNormals, Order order = Order::ByPosition, Repeats repeats = Repeats::LeftOut);

  /// For those who hand a mesh to VTK first, which does not ask whether faces' points exist.
  /// @throws std::invalid_argument as the constructor does before it looks at any face
  static void Check(vtkPolyData* mesh);

  /// Uses an array of one value per point or cell as relative density.
  void SetDensity(vtkDataArray* density, bool ofCells);

  ink::TriangleMesh GetMesh() const;

private:
  /// Those of the faces that are the mesh's own, with the faces' cells.
  void TakeTriangles(vtkPolyData* mesh);
  void SortByPosition();
  /// The mesh's point normals as unit vectors; zero where they are none. @return whether there are any
  bool TakeNormals(vtkPolyData* mesh);
  /// The mean over the faces around each point.
  void AverageNormals();
};

#endif
