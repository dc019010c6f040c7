// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Statistics/IsoStatistics.h"

#include <array>
#include <optional>
#include <span>

namespace ink
{

/// A default iso-value for a volume.
struct IsoSuggestion
{
  /// How the value was found.
  enum class Method
  {
    Boundary, ///< the lowest clear boundary between two materials
    Otsu      ///< no clear boundary: the threshold that best splits the histogram in two
  };
  double value;
  Method method;
};

/// Suggests the iso-value of the outer surface of the main object in a scan.
///
/// For every candidate value v, the number of grid edges that cross v measures the surface's area, and the
/// mean step along them its sharpness (the mean gradient on an iso-surface: Pekar, Wiemker and Hempel, "Fast
/// Detection of Meaningful Isosurfaces for Volume Data Visualization", IEEE Visualization 2001). A surface
/// between two materials is sharpest half way between them. The suggestion is the lowest local maximum of
/// sharpness, as the inside of an object is usually denser, among surfaces that are neither noise (too many
/// single voxels) nor the border of a scanner's field of view (nearly everything inside). If there is no such
/// maximum, it is Otsu's threshold (IEEE Trans. SMC 9, 1979).
///
/// @tparam T any of the scalar types of VTK: signed and unsigned integers of 8 to 64 bits, float, double.
/// @param values dimensions[0] * dimensions[1] * dimensions[2] voxels, x fastest. NaN and infinite ones are
///   skipped.
/// @param dimensions number of voxels along x, y and z.
/// @return nothing if there are fewer than two distinct finite values; otherwise a value strictly between two
///   of them. The same for any number of threads.
/// @throws std::invalid_argument if the size of values is not the product of dimensions.
template <typename T>
std::optional<IsoSuggestion> suggestIsoValue(std::span<const T> values, std::array<int, 3> dimensions);

/// The same, bitwise, for a volume that is not in memory as a whole. Every slice is read at least twice, from
/// the first on, at most `slicesAtOnce` (3 or more) per call.
/// @throws std::invalid_argument if slicesAtOnce is too small or read returns the wrong number of voxels
template <typename T>
std::optional<IsoSuggestion> suggestIsoValue(
  const SliceReader<T>& read, std::array<int, 3> dimensions, int slicesAtOnce);

} // namespace ink
