#pragma once

#include "Statistics/ValueProfile.h"

#include <array>
#include <optional>
#include <span>

namespace ink
{

/// An iso-value for a volume nobody has said anything about.
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
/// For every candidate value v, the grid edges that cross v are a measure of the surface's area, and the
/// mean step along them one of its sharpness (the mean gradient on an iso-surface: Pekar, Wiemker and Hempel,
/// "Fast Detection of Meaningful Isosurfaces for Volume Data Visualization", IEEE Visualization 2001). A
/// surface between two materials is sharpest half way between them. Suggested is the lowest local maximum of
/// that sharpness, as what lies within an object is denser as a rule, among surfaces that are not noise (too
/// many single voxels) and not the border of a scanner's field of view (nearly everything inside). If there
/// is no such maximum, Otsu's threshold (IEEE Trans. SMC 9, 1979) is suggested.
///
/// \tparam T any of the scalar types of VTK: signed and unsigned integers of 8 to 64 bits, float, double.
/// \param values dimensions[0] * dimensions[1] * dimensions[2] voxels, x fastest. NaN and infinite ones are
/// skipped.
/// \param dimensions numbers of voxels along x, y and z.
/// \return nothing if fewer than two different finite values are there; otherwise a value strictly between
/// two
///         that are. The same for any number of threads.
/// \throw std::invalid_argument if the size of values is not the product of dimensions.
template <typename T>
std::optional<IsoSuggestion> suggestIsoValue(std::span<const T> values, std::array<int, 3> dimensions);

/// The same, to the last bit, for a volume that is not in memory as a whole. Every slice is read at least
/// twice, from the first on. \param slicesAtOnce the most that may be asked of read in a call, at least 3
/// \throw std::invalid_argument if slicesAtOnce is too small or read gives fewer or more voxels than asked
/// for
template <typename T>
std::optional<IsoSuggestion> suggestIsoValue(
  const SliceReader<T>& read, std::array<int, 3> dimensions, int slicesAtOnce);

} // namespace ink
