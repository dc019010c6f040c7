// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/ParallelChunks.h"
#include "Fields/Grid/GridGeometry.h"
#include "Fields/Projection.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <stdexcept>

namespace ink
{

/// Samples closer to the surface than this share of the grid's shortest edge are not moved any further.
constexpr double ProjectionTolerance = 1e-4;

/// Moves samples of an iso-surface onto the surface itself, of which the mean of a cell's intersections is
/// but an estimate. No sample moves by more than one cell along any axis; where that or so many steps do not
/// lead closer to the surface, it stays where it is. What a sample becomes depends on the samples of the grid
/// up to two cells around its own, and on nothing else.
///
/// @param field    a field over the grid: a GridField, or a VdbField
/// @param geometry where the grid's cells lie; of which part of the grid makes no difference
/// @param steps    see projectToIsoSurface
/// @param points   x y z of each sample in world units; Real is float or double
/// @throws std::invalid_argument when the points' numbers do not come in threes
/// @return false when `progress` asked to stop; then some samples were not moved
template <Field F, class Real>
bool projectSamples(const F& field, const GridGeometry& geometry, double isoValue, int steps,
  std::span<Real> points, const Progress& progress = {})
{
  if (points.size() % 3 != 0)
  {
    throw std::invalid_argument("points must have three numbers each");
  }
  const glm::dmat3& edges = geometry.stepToWorld();
  const double tolerance =
    ProjectionTolerance * std::min({ glm::length(edges[0]), glm::length(edges[1]), glm::length(edges[2]) });
  const auto project = [&](Real* point)
  {
    const glm::dvec3 start(point[0], point[1], point[2]);
    const glm::dvec3 index = geometry.toGlobalIndex(start);
    const auto within = [&](const glm::dvec3& position)
    {
      const glm::dvec3 moved = glm::abs(geometry.toGlobalIndex(position) - index);
      return moved.x <= 1.0 && moved.y <= 1.0 && moved.z <= 1.0;
    };
    const Projection end = projectToIsoSurface(field, isoValue, start, steps, tolerance, within);
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = static_cast<Real>(end.position[axis]);
    }
  };
  constexpr std::size_t pointsPerChunk = 1024;
  return parallelForEach(
    points.size() / 3, [&](std::size_t n) { project(&points[3 * n]); }, pointsPerChunk, progress);
}

} // namespace ink
