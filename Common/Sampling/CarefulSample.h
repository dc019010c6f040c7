#pragma once

#include "Sampling/CrossedCells.h"
#include "Sampling/Kernels/SamplingKernels.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

/// The sample of one cell, in double and with every exception seen to: for the few cells that the loops of
/// Kernels/ leave over. Internal to Common/Sampling.
namespace ink
{

/// The values of one cell's stencil minus the iso-value, numbered as in CellBatch.
struct CellStencil
{
  double values[StencilSize];

  /// Extrapolates the neighbor before or after an edge from the edge that it continues, which makes the
  /// central difference there one-sided.
  void extrapolateBefore(int axis, int n);
  void extrapolateAfter(int axis, int n);
  /// Makes the largest value 1, so that no gradient's square overflows or vanishes.
  void normalize();
};

/// The corners at the ends of edge n along an axis, and where its neighbors stand in a stencil.
int lowCorner(int axis, int n);
int highCorner(int axis, int n);
int neighborBefore(int axis, int n);
int neighborAfter(int axis, int n);

/// The mean of the surface's intersections with the cell's edges, in the unit cell.
glm::dvec3 meanCrossing(const CellStencil& cell, CrossingRule rule);

/// The unit vector towards smaller values at the point `at` of the unit cell: by the corners' central
/// differences, unless the method is NormalMethod::Cell; where those cancel or all vanish, along the gradient
/// of the cell's own values; and where that vanishes too, along the crossed edges. \param toWorld takes
/// gradients per sample step to vectors along the world's gradient
glm::dvec3 carefulNormal(const CellStencil& cell, const glm::dvec3& at, CrossingRule rule,
  NormalMethod method, const glm::dmat3& toWorld);

} // namespace ink
