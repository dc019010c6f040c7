// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Curves/Streamlines/EvenStreamlines.h"
#include "Curves/Streamlines/FieldTracer.h"
#include "Curves/Streamlines/Streamlines.h"
#include "Fields/Grid/GridField.h"
#include "IsoSurface/IsoSurfaceSamples.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstddef>
#include <span>
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
SurfaceSamples samplesOfGrid(const GridField<T>& field, double isoValue, const Progress& progress = {})
{
  SampleOptions options;
  options.arithmetic = Arithmetic::Double;
  const ActiveCells cells = findActiveCells(field, isoValue, options.rule, {}, progress);
  std::vector<float> normals(3 * cells.count);
  SurfaceSamples samples;
  std::vector<double> coordinates(3 * cells.count);
  placeIsoSurfaceSamples(
    field, isoValue, options, cells, std::span<double>(coordinates), std::span<float>(normals));
  const glm::dmat3& edges = field.geometry().stepToWorld();
  const double volume = std::abs(glm::dot(edges[0], glm::cross(edges[1], edges[2])));
  for (std::size_t i = 0; i < coordinates.size(); i += 3)
  {
    const glm::dvec3 normal(normals[i], normals[i + 1], normals[i + 2]);
    samples.positions.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
    double across = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      across += std::abs(glm::dot(normal, edges[axis]));
    }
    samples.area += across > 0.0 ? volume / across : 0.0;
  }
  return samples;
}

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
