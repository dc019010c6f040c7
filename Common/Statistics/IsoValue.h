// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Statistics/IsoStatistics.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// An iso-value that suits a volume, with what its surface shows.
struct IsoSuggestion
{
  enum class Boundary
  {
    Outermost, ///< the lowest clear boundary between two materials
    Inner,     ///< one between the outermost and the densest
    Densest,   ///< the highest clear boundary, if it is not the only one
    Bone,      ///< that of bone in CT, by its Hounsfield units
    Labels,    ///< the edge of all labels of a segmentation
    Sign, ///< no boundary is clear: 0, where an implicit function, such as a signed distance, has its surface
    None  ///< no boundary is clear: Otsu's threshold, which best splits the histogram in two, or one below
  };
  double value;
  Boundary boundary;
  double keptShare;        ///< the share of the finite voxels that lie above the value, 0 to 1
  std::int64_t labels = 0; ///< how many different ones lie above the value, of Labels; else 0
  /// It is of the positive values of a field of both signs that fades to 0, as an orbital, or of differences.
  bool isLobe = false;
};

/// Suggests up to three iso-values for a scan or a simulation, the best first.
///
/// For every candidate value v, the number of grid edges that cross v measures the surface's area, and the
/// mean step along them its sharpness (the mean gradient on an iso-surface: Pekar, Wiemker and Hempel, "Fast
/// Detection of Meaningful Isosurfaces for Volume Data Visualization", IEEE Visualization 2001). A surface
/// between two materials is sharpest half way between them, so each local maximum of sharpness is a boundary.
/// Where a material varies, as bone does, the sharpness rises up to its densest parts; of the values around a
/// maximum that are nearly as sharp, the sharpest is taken that has nearly the greatest total step (Pekar's
/// total gradient), which leaves the surface whole.
///
/// Where the materials on both sides have peaks in the histogram and the boundary is far from the middle of
/// these, it is moved there as far as it is nearly as sharp.
///
/// Where the first boundary cuts into a material of different parts, as higher values do in MR, it is moved
/// down to where its area is the least, nearly: there the surface has no holes.
///
/// Where a material has no boundary but at its brightest spots, as MR has that fades away from a coil, the
/// surface around all of it comes first: where the area is the least, nearly, as long as it is half as sharp.
///
/// Not suggested are noise (too many single voxels, and many more than at lower values), the border of a
/// scanner's field of view (nearly everything inside), fragments (less than a hundredth of what a lower
/// boundary keeps), the peaks of smooth fields, as simulations have (less than a twentieth of the area of
/// surfaces at lower values, and no material above), the change of sign of fields that fade to 0, as
/// orbitals, the haze around a boundary whose step times what it keeps is clearly more, and, as long as there
/// are other boundaries, the edge of a mask (edges that begin in a region of one value).
///
/// Where noise can hide boundaries, they are those of the smoothed volume, see smoothedSlices, from the first
/// on that is clean in the values themselves, if there are no others or if that lies around them.
///
/// Where some sides are padded with the lowest value, so that all others fill a box, only that box counts, if
/// there is a boundary in it.
///
/// Where a field of view is padded with a value far below all others, as CT's is below air, that counts as
/// the least of these, if the boundaries then lie well within.
///
/// Where nearly all values are as large as those around them, they are the labels of a segmentation rather
/// than measured. One between two labels says nothing then; the only suggestion is the edge of all labels,
/// half way from the lowest value, the background, to the next.
///
/// Where values are Hounsfield units, with air and soft tissue where CT has them, bone comes second, at 200,
/// if no boundary is as dense: in a trunk its density differs too much for a clear one. There vertebrae are
/// whole, at 300 they have holes.
///
/// Otherwise the first suggestion is the outermost boundary, the lowest, as the inside of an object is
/// usually denser; the others follow by their total step. Where all six sides of the volume cut it, as in a
/// scan that was cropped, the inside of the lungs would be seen: then it comes second, after the clearest one
/// that keeps much less. If there is no boundary, it is 0 where the values have both signs and few edges
/// cross it, and then Otsu's threshold (IEEE Trans. SMC 9, 1979), of what lies above it where its surface
/// would be noise, of the positive values where they are differences around a background of 0 or fade to it,
/// moved down to the whole surface around it, if there is one, or else as the first boundary is.
///
/// @tparam T any of the scalar types of VTK: signed and unsigned integers of 8 to 64 bits, float, double.
/// @param values dimensions[0] * dimensions[1] * dimensions[2] voxels, x fastest. NaN and infinite ones are
///   skipped, and a fill value, see ValueBins.
/// @param dimensions number of voxels along x, y and z.
/// @return nothing if there are fewer than two distinct finite values; otherwise values strictly between two
///   of them. The same for any number of threads.
/// @throws std::invalid_argument if the size of values is not the product of dimensions.
template <typename T>
std::vector<IsoSuggestion> suggestIsoValues(std::span<const T> values, std::array<int, 3> dimensions);

/// The same, bitwise, for a volume that is not in memory as a whole. Every slice is read at least twice, four
/// times if it is smoothed, once more if values are labels, fill the volume or begin at masks, and those of a
/// box within padding, or all in a padded field of view, as often again, always from the first on, at most
/// `slicesAtOnce` (3 or more) per call.
/// @throws std::invalid_argument if slicesAtOnce is too small or read returns the wrong number of voxels
template <typename T>
std::vector<IsoSuggestion> suggestIsoValues(
  const SliceReader<T>& read, std::array<int, 3> dimensions, int slicesAtOnce);

/// Puts the clearest boundary within the outermost one first, if there is one: as bone in a CT scan.
void preferInner(std::vector<IsoSuggestion>& suggestions);

} // namespace ink
