// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkIndexMesh_h
#define InkIndexMesh_h

#include "Fields/Grid/ElementMarks.h"
#include "IsoSurface/ActiveCellComponents.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

class vtkImageData;

/// A surface in the index space of a grid, or of a grid that is divided more finely.
struct InkIndexMesh
{
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<glm::dvec3> Points;
  std::vector<Triangle> Triangles;

  void Append(const InkIndexMesh& other);
  void RemoveUnusedPoints();
  /// Removes the triangles of the connected parts that are not selected. A part counts as many cells as it
  /// has points: a closed surface has about as many points as it has active cells. All points are used.
  void KeepParts(const ink::ComponentSelection& selection);
};

/// Which triangles of an image's surfaces count: those of finite points, in cells that the image does not
/// skip.
class InkCellFilter
{
public:
  /// @param samples of the image
  /// @param subdivision into how many cells of the surfaces' grid one of the image is divided
  InkCellFilter(const glm::ivec3& samples, const glm::ivec3& subdivision, vtkImageData* image);

  bool IsKept(const InkIndexMesh& mesh, const InkIndexMesh::Triangle& triangle) const;

private:
  glm::ivec3 Cells;
  glm::ivec3 Subdivision;
  ink::ElementMarks Skipped;
};

#endif
