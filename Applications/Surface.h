#pragma once

#include "Input.h"
#include "SampleMesh.h"

class vtkPolyData;

namespace ink::cli
{

/// The points that are drawn: those of iso-surfaces of a volume, or samples or the vertices of a mesh.
struct Surface
{
  vtkSmartPointer<vtkPolyData> points; ///< with normals
  std::vector<std::string> notes;
};

/// \param isoValues empty: one is chosen.
/// \param meshes samples a mesh, or with a count of 0 leaves its vertices to be drawn; points without
/// polygons are
///        always drawn themselves
/// \throw UsageError for options that the input does not have, Failure if there is nothing to draw or
/// more
///        than memory has room for.
Surface makeSurface(const Input& input, const std::vector<double>& isoValues, MeshSampler& meshes,
  const Memory& memory, Progress& progress);

} // namespace ink::cli
