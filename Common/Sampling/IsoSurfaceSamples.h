#pragma once

#include "Fields/GridField.h"
#include "Parallel/ParallelFor.h"
#include "Sampling/CrossedCells.h"

#include <span>

namespace ink
{

/// Places one sample in each of the given cells: at the mean of the iso-surface's intersections with the
/// cell's edges, with the normal there (Zhang et al. 2014, section 5.1).
///
/// \param cells   from findCrossedCells with the same field, isoValue and rule; their order is the samples'
/// \param points  3 * cells.count numbers, x y z of each sample in world units; Real is float or double
/// \param normals 3 * cells.count numbers, or empty for none. Unit vectors towards smaller values: the
/// trilinear
///                interpolation of the unit normals that central differences give the cell's eight corners.
///                Where those cancel or all vanish, along the gradient of the cell's own values, and where
///                that vanishes too, along the crossed edges
/// \throws std::invalid_argument when a span has another length
/// \returns false when `progress` asked to stop; then some samples were left out
template <class T, class Real>
bool placeIsoSurfaceSamples(const GridField<T>& field, double isoValue, CrossingRule rule,
  const CrossedCells& cells, std::span<Real> points, std::span<float> normals, const Progress& progress = {});

/// The radius, in world units, of discs around the samples of any iso-surface of the grid that leave no
/// holes: half the diagonal of a cell. One radius for all of them, since lines of an even width need splats
/// of one size.
double isoSurfaceSampleRadius(const GridGeometry& geometry);

} // namespace ink
