// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "IsoSurface/ActiveCellComponents.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

namespace ink
{
struct FiniteRange;
}

namespace ink::cli
{

struct Input;
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
  int cut = 0;
  bool cellIds = false;     ///< the array CellId, of volumes that are images
  ComponentSelection parts; ///< those that stay, of volumes that are not
  double smoothing = 0.0;
  int smoothingTarget = 0;
  int subdivision = 1;
};

/// Sets what both samplers of iso-surfaces have in common; one surface at a time.
template <class Sampler>
void setUp(Sampler* sampler, const VolumeSampling& sampling)
{
  sampler->SetNumberOfContours(1);
  sampler->SetCrossingRule(sampling.crossingRule);
  sampler->SetOutputPointsPrecision(sampling.precision);
  sampler->SetComputeNormals(sampling.normals);
  sampler->SetComputeRadius(sampling.radius);
  sampler->SetCut(sampling.cut);
  sampler->SetSmoothing(sampling.smoothing);
  sampler->SetSmoothingTarget(sampling.smoothingTarget);
  sampler->SetSubdivision(sampling.subdivision);
  sampler->GenerateVerticesOff();
}

/// Takes points of a surface, which is the index of its iso-value. Those of a surface come in their order.
using PointSink = std::function<void(int surface, vtkPolyData* points)>;

/// What a point takes at most while it is made: coordinates in double, a normal, a radius and an index.
constexpr std::uint64_t bytesPerPoint = 48;

/// The points of a cell that a surface goes through, about: it is divided along two axes.
inline std::uint64_t pointsPerCell(const VolumeSampling& sampling)
{
  const auto subdivision = static_cast<std::uint64_t>(sampling.subdivision);
  return subdivision * subdivision;
}

/// Adds the array SurfaceIndex: all points belong to that one.
void addSurfaceIndex(vtkPolyData* points, int surface);

/// The iso-value that the file is about or that suits the volume, in a list; an empty one if the volume's
/// values are not at hand. @param notes what was chosen is added. @throws Failure if there is none
std::vector<double> chooseIsoValue(const Input& input, std::vector<std::string>& notes, Progress& progress);

/// Samples a volume whatever holds it: one of the two below, at the surface that the file is about where no
/// iso-value is given.
std::vector<std::string> sampleVolume(const Input& input, VolumeSampling sampling, const Memory& memory,
  const PointSink& sink, Progress& progress);

/// What samples a volume that is not in memory but can be sampled from its file; as the function below.
using VolumeSampler = std::function<std::vector<std::string>(
  const VolumeSampling& sampling, const Memory& memory, const PointSink& sink, Progress& progress)>;

/// Samples all iso-surfaces, a few slices at a time if memory asks for it: the points are the same.
/// @return notes for the user
/// @throws UsageError for iso-values that the volume does not have, Failure if there are no points or if
/// memory
///        is not enough.
std::vector<std::string> sampleVolume(VolumeSlices& volume, const VolumeSampling& sampling,
  const Memory& memory, const PointSink& sink, Progress& progress);

/// @param values that the volume has
/// @throws UsageError for iso-values that it does not have, Failure if it has no surface at any.
void checkIsoValues(const std::vector<double>& isoValues, const FiniteRange& values);

} // namespace ink::cli
