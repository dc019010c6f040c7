// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkMeshContourFinder_h
#define InkMeshContourFinder_h

#include "InkContourFinder.h"
#include "InkMeshTriangles.h"

#include "Curves/Contours/MeshContours.h"

#include <optional>

/// Contours of a mesh (ink::MeshContours).
class InkMeshContourFinder : public InkContourFinder
{
public:
  /// Does nothing where it is ready for these.
  /// @return whether the mesh was read
  /// @throws std::invalid_argument as InkMeshTriangles and ink::MeshContours
  bool Update(vtkPolyData* mesh, const ink::MeshContourOptions& options);

  Found Find(const ink::Eye& eye) const override;

private:
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkMTimeType MeshTime = 0;
  ink::MeshContourOptions Options;
  std::optional<InkMeshTriangles> Triangles;
  std::optional<ink::MeshContours> Finder;
};

#endif
