#pragma once

#include "Input.h"

class vtkPolyData;

namespace ink::cli
{

/// The points that are drawn: those of iso-surfaces of a volume, or the vertices of a mesh.
struct Surface
{
  vtkSmartPointer<vtkPolyData> points; ///< with normals
  std::vector<std::string> notes;
};

/// \param isoValues empty: one is chosen.
/// \throw UsageError for iso-values that the volume does not have, Failure if there is nothing to draw.
Surface makeSurface(const Input& input, const std::vector<double>& isoValues, Progress& progress);

} // namespace ink::cli
