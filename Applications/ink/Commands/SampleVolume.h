// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input.h"

#include <string>
#include <vector>

namespace ink
{
struct FiniteRange;
}

namespace ink::cli
{

/// How the iso-surfaces of a volume become points. The numbers are vtkInkIsoSurfaceAlgorithm's.
struct VolumeSampling
{
  std::vector<double> isoValues; ///< empty: one is chosen
  int crossingRule = 0;
  int precision = 2;
  bool normals = true;
  bool radius = true;
  bool surfaceIndex = false; ///< an array of this name: which of the iso-values a point belongs to
};

/// The iso-value that the file is about or that suits the volume, in a list; an empty one if the volume's
/// values are not at hand.
/// @param inner ink::preferInner
/// @param notes what was chosen is added
/// @throws Failure if there is none
std::vector<double> chooseIsoValue(const Input& input, const InkMemoryBudget& memory, bool inner,
  std::vector<std::string>& notes, Progress& progress);

/// Samples all iso-surfaces, a part of the points at a time, at the surface that the file is about where no
/// iso-value is given.
/// @return notes for the user
/// @throws UsageError for iso-values that the volume does not have, Failure if there are no points or if
/// memory is not enough
std::vector<std::string> sampleVolume(const Input& input, const VolumeSampling& sampling,
  const InkMemoryBudget& memory, const vtkInkIsoSurfaceAlgorithm::PartSink& sink, Progress& progress);

/// @param values that the volume has
/// @throws UsageError for iso-values that it does not have, Failure if it has no surface at any.
void checkIsoValues(const std::vector<double>& isoValues, const FiniteRange& values);

} // namespace ink::cli
