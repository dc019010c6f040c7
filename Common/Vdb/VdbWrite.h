#pragma once

#include "Fields/GridField.h"
#include "Vdb/VdbGrid.h"

#include <optional>
#include <string>

namespace ink
{

/// How a dense volume becomes a sparse grid.
struct VdbConversion
{
  /// Keep only a narrow band around the surfaces of this value.
  std::optional<double> around;
  /// How many voxels the band goes on beyond the corners of the cells that the surface crosses: 1 is what
  /// normals need.
  int halfWidth = 3;
  /// Of the grid.
  std::string name = "density";
};

/// Makes a sparse grid from a dense volume. T is float or double.
///
/// With `around`, active are the voxels of the band, with their values. The others are inactive: those below
/// the value have the band's lowest value, which is the grid's background, and those at or above it the
/// band's highest. A missing sample stays missing, so that no surface appears that the volume does not have.
///
/// Without `around`, all voxels keep their values; the background is the lowest finite value, and active are
/// the voxels that have another.
///
/// Either way equal regions become tiles, the grid's domain is the volume's box, and the grid's origin,
/// spacing and direction are the volume's, to the bit. Surfaces at `around` have the same cells, points and
/// normals as the volume's.
/// \throws std::invalid_argument if `halfWidth` is below 1, if no surface of the value exists, or if samples
///         are hidden
template <class T>
VdbGrid makeVdbGrid(const GridField<T>& volume, const VdbConversion& conversion);

/// The bytes of a .vdb file with the grid alone, zip- or Blosc-compressed as OpenVDB was built.
std::string serializeVdb(const VdbGrid& grid);

} // namespace ink
