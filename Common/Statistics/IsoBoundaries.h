// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Statistics/IsoStatistics.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

/// Internal to Common/Statistics: the boundaries between a volume's materials, see suggestIsoValues.
namespace ink
{

/// What keeps less than this fraction of the voxels that the lowest boundary keeps is a fragment.
inline constexpr double fragmentShare = 0.01;

/// Whether so many edges are too large a part of a volume's for a surface, rather than noise, to cross them.
bool areTooMany(std::int64_t edges, const IsoStatistics& statistics);

/// Whether most of the edges that cross a threshold lie at the edge of a mask.
bool isMask(const IsoStatistics& statistics, std::size_t threshold);

/// Whether the lowest of the clear boundaries is that of a field of view which padding of the lowest value
/// surrounds: noise lies above it, no material, and the padding's edges have no larger steps than that noise.
/// @param boundary,next thresholds, of the lowest boundary and of the one above it
bool isPadding(const IsoStatistics& statistics, std::size_t boundary, std::size_t next);

struct IsoBoundary
{
  double threshold;  ///< as a position between bins
  std::size_t index; ///< the threshold at or below it
  double totalStep;
  /// The thresholds around it that are nearly as sharp, from `begin` up to but excluding `end`.
  std::size_t begin;
  std::size_t end;

  bool contains(const IsoBoundary& other) const
  {
    return other.index >= this->begin && other.index < this->end;
  }
};

/// The clear boundaries, from the lowest to the highest, those of masks only if there are no others,
/// or small ones.
std::vector<IsoBoundary> findBoundaries(const IsoStatistics& statistics, const std::vector<double>& kept);

/// Moves boundaries half way between the values of the materials on both sides, as far as they stay nearly as
/// sharp. Where a denser material touches the surface, too, the sharpness is greatest somewhat nearer to its
/// value.
void centerBoundaries(const IsoStatistics& statistics, std::vector<IsoBoundary>& boundaries);

/// Moves a boundary down to where its surface is whole, as far as it stays nearly as sharp, with .7 of its
/// mean step or more where no mask cuts it: where tissues differ, as in MR, and fade far from the coil,
/// higher values cut some of them out, with as sharp a surface and more of it.
void mendBoundary(const IsoStatistics& statistics, IsoBoundary& boundary);

/// The surface around all of what only brighter parts have a boundary of their own in, as the brightest spots
/// of a material, or what is within the skin: where the steps become larger from its edge up to those, none
/// of the thresholds around it is the sharpest. It lies where the area is the least, nearly.
/// @param inner the lowest boundary, or a threshold where none is clear
std::optional<IsoBoundary> findSurfaceAround(
  const IsoBoundary& inner, const IsoStatistics& statistics, const std::vector<double>& kept, bool isClear);

} // namespace ink
