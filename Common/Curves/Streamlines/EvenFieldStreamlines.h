// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Curves/Streamlines/EvenStreamlines.h"
#include "Curves/Streamlines/FieldTracer.h"
#include "Curves/Streamlines/Streamlines.h"
#include "Fields/Grid/GridField.h"

#include <glm/vec3.hpp>

#include <vector>

namespace ink
{

using FieldStreamlines = StreamlinesOn<FieldPoint>;

/// Positions all over an iso-surface from which lines may start.
struct SurfaceSamples
{
  std::vector<glm::dvec3> positions; ///< near the surface; about as many in every part of it
  double area = 0.0;                 ///< of the surface, in world units squared
};

/// Those of a grid: one position in each cell that the iso-surface intersects. A plane of unit normal n
/// intersects |n . a| + |n . b| + |n . c| cells of edges a, b and c in the area of their volume, on average,
/// so that each position stands for a known part of the area.
template <class T>
SurfaceSamples samplesOfGrid(const GridField<T>& field, double isoValue, const Progress& progress = {});

/// Evenly spaced lines of curvature on the iso-surface of a field: evenStreamlines without a mesh, by the
/// same code, see StreamlinePlacement and FieldTracer. Positions are in `positions`, normals in `points`.
/// @param samples of the surface. Where no line can be found otherwise, it starts at one of them
/// @param maximum along maximum or minimum curvature
/// @param negligible a curvature that counts as none, in 1 / world unit
/// @param options of `trace` the greatest step, of a quarter of the spacing at most, greatest length, umbilic
///   limit and the distance at which lines are closed count
/// @param progress when it asks to stop, the result is empty
/// @throws std::invalid_argument as evenStreamlines
FieldStreamlines evenFieldStreamlines(const FieldSurface& surface, const SurfaceSamples& samples,
  bool maximum, double negligible, const EvenStreamlineOptions& options, const Progress& progress = {});

} // namespace ink
