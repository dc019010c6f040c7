#pragma once

#include "Sampling/CrossedCells.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

/// The arithmetic of iso-surface sampling for several cells at once: plain loops over arrays by sample and
/// then by cell, which compilers turn into vector instructions. Internal to Common/Sampling.
namespace ink
{

/// How many cells are worked on at once.
constexpr int Lanes = 16;

/// One number for each of them.
using Batch = double[Lanes];

/// The two axes across a given one.
constexpr int Across[3][2] = { { 1, 2 }, { 0, 2 }, { 0, 1 } };

/// The samples that a cell's point and normal depend on: its 8 corners, corner c being on the upper side
/// along axis a where bit a of c is set, and the two outer neighbours of each of its 12 edges, along that
/// edge. Edge n of the four that run along an axis is on the upper side of the first axis across where bit 0
/// of n is set, and of the second where bit 1 is.
constexpr int Corners = 8;
constexpr int Edges = 12;
constexpr int StencilSize = Corners + 2 * Edges;

/// The stencils of the cells: values of the field minus the iso-value.
using Stencils = Batch[StencilSize];

constexpr int lowCorner(int axis, int n)
{
  return (n & 1) << Across[axis][0] | (n >> 1) << Across[axis][1];
}
constexpr int highCorner(int axis, int n)
{
  return lowCorner(axis, n) | 1 << axis;
}
constexpr int neighbourBefore(int axis, int n)
{
  return Corners + 4 * axis + n;
}
constexpr int neighbourAfter(int axis, int n)
{
  return Corners + Edges + 4 * axis + n;
}

/// The edge along an axis that a corner belongs to.
constexpr int edgeAt(int axis, int corner)
{
  return (corner >> Across[axis][0] & 1) | (corner >> Across[axis][1] & 1) << 1;
}

/// The mean of the surface's intersections with each cell's edges, in the unit cell; only corners are read.
template <CrossingRule rule>
void findMeanCrossings(const Stencils& cells, Batch (&mean)[3]);

/// The trilinear interpolation, at the point `at` of each unit cell, of the unit vectors along the corners'
/// central-difference gradients. `toWorld` takes gradients per sample step to their direction in the world. A
/// corner with no gradient adds nothing.
void interpolateDirections(
  const Stencils& cells, const Batch (&at)[3], const glm::dmat3& toWorld, Batch (&directions)[3]);

/// matrix * (x, y, z) for each cell.
void transform(const glm::dmat3& matrix, const Batch (&from)[3], Batch (&to)[3]);

/// The gradient, per sample step, of the trilinear interpolation of one cell's corners, at the point `at` of
/// the unit cell.
glm::dvec3 cellGradient(const Stencils& cells, int lane, const glm::dvec3& at);

/// How many more of one cell's crossed edges rise than fall, along each axis.
template <CrossingRule rule>
glm::dvec3 risingEdges(const Stencils& cells, int lane);

} // namespace ink
