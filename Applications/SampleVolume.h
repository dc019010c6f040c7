#pragma once

#include <functional>
#include <string>
#include <vector>

class vtkImageData;
class vtkPolyData;

namespace ink::cli
{

class Progress;

/// How the iso-surfaces of a volume become points. The numbers are vtkInkIsoSurfaceSampler's.
struct VolumeSampling
{
  std::vector<double> isoValues; ///< empty: one is chosen
  int crossingRule = 0;
  int precision = 2;
  bool normals = true;
  bool radius = true;
  bool surfaceIndex = false; ///< an array of this name: which of the iso-values a point belongs to
};

/// Takes points of a surface, which is the index of its iso-value.
using PointSink = std::function<void(int surface, vtkPolyData* points)>;

/// Samples all iso-surfaces.
/// \return notes for the user
/// \throw UsageError for iso-values that the volume does not have, Failure if there are no points.
std::vector<std::string> sampleVolume(
  vtkImageData* image, const VolumeSampling& sampling, const PointSink& sink, Progress& progress);

} // namespace ink::cli
