#pragma once

#include "Input.h"
#include "SampleMesh.h"

#include <optional>

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
/// \param samples on a mesh; none: as many as suit it, 0: its vertices are drawn; points without polygons
///        are always drawn themselves
/// \param cloud for points without polygons
/// \throw UsageError for options that the input does not have, Failure if there is nothing to draw or
/// more
///        than memory has room for.
Surface makeSurface(const Input& input, const std::vector<double>& isoValues,
  std::optional<long long> samples, const CloudSampling& cloud, const Memory& memory, Progress& progress);

} // namespace ink::cli
