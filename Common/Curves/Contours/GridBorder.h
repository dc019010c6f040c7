// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Contours/Contours.h"
#include "Fields/Grid/GridField.h"
#include "IsoSurface/CellBricks.h"

#include <span>

namespace ink
{

/// Where a grid's iso-surface ends: at the grid's border, at cells that are left out, and where samples are
/// missing. The surface is that of GridContours, linear in the six tetrahedra of a cell; so its border are
/// lines across those faces of active cells that have no active cell on their other side. It is the same for
/// any eye, and a closed surface has none.
///
/// @param bricks from collectBricks, of cells that findActiveCells found by CrossingRule::HalfOpen
/// @return chains, all of the kind Border and of radial curvature 0; closed, unless lines branch
template <class T>
Contours gridBorder(
  const GridField<T>& field, double isoValue, std::span<const CellBrick> bricks, const ContourArrays& arrays);

} // namespace ink
