// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Fields/Resampling/SliceDistances.h"
#include "IsoSurface/ActiveCells.h"
#include "IsoSurface/IsoSurfaceSamples.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace ink
{

template <class T>
class GridField;
class GridGeometry;

/// What a Gaussian smooths.
enum class SmoothingTarget
{
  Surface, ///< the surface and its normals
  /// The normals. The surface is that of values smoothed by a kernel of fourth order of half the deviation:
  /// it keeps its place, and parts as thin as the Gaussian.
  Normals
};

/// Of the Gaussian's deviation, for the kernel of fourth order of SmoothingTarget::Normals. With more, thin
/// parts are lost: of vessels of 1.8 to 3.5 voxels with 10 % noise 16 % with .5 and 32 % with 1 / sqrt(2);
/// with less, outlines are rough: off by .10 voxels with .5, .12 with .35 and .15 with 0
/// (TradeoffSmoothing, a deviation of 1.4).
inline constexpr double fourthOrderShare = 0.5;

/// How a grid is resampled before samples are placed, see AxisResampling.
struct IsoSurfaceResampling
{
  glm::dvec3 deviation = glm::dvec3(0.0); ///< of the Gaussian along each axis, in samples of the grid
  glm::ivec3 subdivision = glm::ivec3(1); ///< cells that take the place of one, along each axis
  SmoothingTarget target = SmoothingTarget::Surface;
  /// Whether values are labels: each is replaced by whether it is at or above the iso-value, 1 or 0, before
  /// anything else is made of it, and the surface is that of this mask at maskIsoValue.
  bool ofMask = false;
  /// If given, what is resampled are distances from the contours within these slices, and the surface is that
  /// of a distance of 0, see sliceDistances.
  std::optional<ThickSlices> slices = {};
  /// Of labels: whether there is a groove, of normals, between those that meet on the surface, see
  /// LabelBorderNormals.
  bool borders = false;

  /// What is left to do with the distances themselves.
  IsoSurfaceResampling ofDistances() const
  {
    IsoSurfaceResampling rest = *this;
    rest.slices = {};
    rest.ofMask = false;
    return rest;
  }

  /// Whether the grid stays what it is.
  bool isIdentity() const
  {
    return this->deviation == glm::dvec3(0.0) && this->subdivision == glm::ivec3(1) && !this->ofMask &&
      !this->slices;
  }
};

inline constexpr int largestSubdivision = 64;

/// How many cells take the place of one along an axis of longer voxels: as many as make them about cubes, but
/// 8 as long as they are no more than three times as long as wide then: longer ones leave gaps between
/// slices. Cubes throughout draw finer lines, of which fewer are found of 48 x 48 x 16 voxels (F .34 instead
/// of .38).
/// @param ratio the spacing along the axis, by the smallest one
/// @param subdivision cells per sample along the axis of the smallest spacing
int subdivisionAlong(double ratio, int subdivision);

/// Half way between outside and inside.
inline constexpr double maskIsoValue = 0.5;

/// The same smoothing in all world directions, and cells that are about cubes where voxels are not.
/// @param smoothing the Gaussian's standard deviation in multiples of the smallest spacing
/// @param subdivision cells per sample along the axis of the smallest spacing; along others in proportion to
///   the spacing, see subdivisionAlong
/// @param shapeBased whether distances are interpolated between slices, if they are thick
/// @return the identity for 0 and 1, of values
IsoSurfaceResampling makeIsoSurfaceResampling(const GridGeometry& geometry, double smoothing, int subdivision,
  SmoothingTarget target, bool ofMask = false, bool shapeBased = false);

/// Samples around a cell of the grid that its samples depend on, along each axis.
/// @param smoothing, subdivision as for makeIsoSurfaceResampling
/// @param slices whose distances are interpolated
glm::ivec3 isoSurfaceResamplingReach(
  double smoothing, int subdivision, const std::optional<ThickSlices>& slices = {});

/// The grid whose cells have samples.
GridGeometry resampledGeometry(const GridGeometry& geometry, const glm::ivec3& subdivision);

/// The least and greatest value around each tile of a grid, of those that later calls need not read.
class TileRanges
{
public:
  void clear() { *this = TileRanges(); }
  std::size_t bytes() const { return (this->Low.capacity() + this->High.capacity()) * sizeof(double); }

private:
  template <class Work>
  friend class ResampledSampler;

  /// What the ranges belong to.
  struct Key
  {
    glm::ivec3 samples = glm::ivec3(0);
    glm::ivec3 begin = glm::ivec3(0);
    glm::ivec3 end = glm::ivec3(0);
    glm::ivec3 tile = glm::ivec3(0);
    glm::ivec3 reach = glm::ivec3(0);
    bool operator==(const Key&) const = default;
  };

  Key Of;
  std::vector<double> Low; ///< NaN where not known
  std::vector<double> High;
};

/// sampleIsoSurfaces for a grid that is smoothed and divided into smaller cells, tile by tile: at no time is
/// there more of the resampled grid than a tile per thread, and tiles without a surface are not resampled.
/// Samples are sorted by iso-value, then by tile, then by cell. Parts of a grid give the samples of the
/// whole, bitwise, where they have isoSurfaceResamplingReach() more samples around the selected cells.
///
/// 64-bit integers and doubles are resampled in double, others as float if `options.arithmetic` is single.
///
/// @param selection cells of the grid itself; all parts of a skipped cell, or of one with a missing corner,
///   are skipped
/// @param projectionSteps see projectSamples
/// @param ranges kept from call to call for the same values, but of distances; the caller must clear them
///   when the values change. May be null
/// @param grow called for all samples, or for those of one surface after the other, of masks and distances
/// @param counts output: the number of samples of each iso-value
/// @return false when `progress` asked to stop
template <class T>
bool sampleResampledIsoSurfaces(const GridField<T>& field, std::span<const double> isoValues,
  const SampleOptions& options, const CellSelection& selection, const IsoSurfaceResampling& resampling,
  int projectionSteps, TileRanges* ranges, const GrowRoom& grow, std::vector<std::size_t>& counts,
  const Progress& progress = {});

} // namespace ink
