// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Vdb/VdbGrid.h"

#include <optional>
#include <string>

namespace ink
{

template <class T>
class GridField;

/// Options for converting a dense volume to a sparse grid.
struct VdbConversion
{
  /// Keep only a narrow band around the iso-surface of this value.
  std::optional<double> around;
  /// The half-width of the band: voxels beyond the corners of active cells. Normals need 1.
  int halfWidth = 3;
  /// The grid's name.
  std::string name = "density";
};

/// Makes a sparse grid from a dense volume. T is float or double.
///
/// With `around`, the voxels of the band are active and keep their values. All others are inactive: those
/// below the iso-value have the band's lowest value, which is the grid's background, and those at or above it
/// the band's highest. Missing samples stay missing, so that no new surface appears.
///
/// Without `around`, all voxels keep their values; the background is the lowest finite value, and voxels with
/// other values are active.
///
/// Either way constant regions become tiles, the grid's domain is the volume's extent, and the grid's origin,
/// spacing and direction are bitwise equal to the volume's. Iso-surfaces at `around` have the same cells,
/// points and normals as the volume's.
/// @throws std::invalid_argument if `halfWidth` is below 1, if there is no iso-surface of the value, or if
///   samples are hidden
template <class T>
VdbGrid makeVdbGrid(const GridField<T>& volume, const VdbConversion& conversion);

/// The bytes of a .vdb file with only this grid, zip- or Blosc-compressed depending on how OpenVDB was built.
std::string serializeVdb(const VdbGrid& grid);

} // namespace ink
