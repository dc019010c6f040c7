#pragma once

#include "Statistics/ValueSummary.h"

#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

namespace ink::cli
{

struct Memory;
class Progress;
class VolumeSlices;

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

/// Takes points of a surface, which is the index of its iso-value. Those of a surface come in their order.
using PointSink = std::function<void(int surface, vtkPolyData* points)>;

/// Samples all iso-surfaces, a few slices at a time if memory asks for it: the points are the same.
/// \return notes for the user
/// \throw UsageError for iso-values that the volume does not have, Failure if there are no points or if
/// memory
///        is not enough.
std::vector<std::string> sampleVolume(VolumeSlices& volume, const VolumeSampling& sampling,
  const Memory& memory, const PointSink& sink, Progress& progress);

/// \param values that the volume has
/// \throw UsageError for iso-values that it does not have, Failure if it has no surface at any.
void checkIsoValues(const std::vector<double>& isoValues, const ValueSummary& values);

} // namespace ink::cli
