// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "IsoSurface/ActiveCells.h"
#include "Simd/SamplingKernels.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

/// Robust placement of the sample of one cell, in double precision and with all special cases: for the few
/// cells that the kernels cannot handle. Internal to Common/IsoSurface.
namespace ink
{

/// The values of one cell's stencil minus the iso-value, numbered as in CellBatch.
struct CellStencil
{
  double values[StencilSize];

  /// Extrapolates the neighbor before or after an edge linearly along the edge, which makes the central
  /// difference there one-sided.
  void extrapolateBefore(int axis, int n);
  void extrapolateAfter(int axis, int n);
  /// Scales the largest value to 1, so that squared gradients neither overflow nor underflow.
  void normalize();
};

/// The corners at the ends of edge n along an axis, and the stencil indices of its neighbors.
int lowCorner(int axis, int n);
int highCorner(int axis, int n);
int neighborBefore(int axis, int n);
int neighborAfter(int axis, int n);

/// The mean of the surface's intersections with the cell's edges, in coordinates of the unit cell.
glm::dvec3 meanCrossing(const CellStencil& cell, CrossingRule rule);

/// The unit normal, towards smaller values, at the point `at` of the unit cell: from the corners' central
/// differences, unless the method is NormalMethod::Cell; where those cancel or all vanish, along the gradient
/// of the cell's own values; and where that vanishes too, along the intersected edges. `toWorld` maps
/// gradients per sample step to vectors along the world gradient.
glm::dvec3 robustNormal(const CellStencil& cell, const glm::dvec3& at, CrossingRule rule, NormalMethod method,
  const glm::dmat3& toWorld);

} // namespace ink
