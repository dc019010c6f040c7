// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Statistics/IsoStatistics.h"

#include <glm/vec3.hpp>

#include <array>
#include <limits>

namespace ink
{

template <class T>
class GridField;

/// What blurs an iso-surface's normals, in the unit of the values.
struct NoiseEstimate
{
  double noise = 0.0;   ///< the standard deviation of the noise of a sample, that of rounding included
  double step = 0.0;    ///< the difference between both sides of the surface; 0 if there is no surface
  double quantum = 0.0; ///< the difference between neighboring gray levels; 0 for continuous values
  /// The samples in a row along an axis that are on one side of the surface, from where it is crossed: fewer
  /// in a tenth of the positions only. Up to thickEnough, which stands for more, too. Of the positions that a
  /// line along x or y reaches from the border of the grid, as long as there are any: what is inside, as the
  /// layers of a skull in MR, is not seen
  double thickness = thickEnough;
  static constexpr double thickEnough = 5.0;
  /// The same, but fewer in a quarter of the positions: gaps within what is thick do not count.
  double usualThickness = thickEnough;
  /// The deviation of a Gaussian, in samples, that keeps what is inside: less would be needed in a tenth of
  /// the positions only, of those that are seen from outside; at least that which keeps a single sample.
  double keeping = std::numeric_limits<double>::infinity();
  bool labels = false; ///< whether all values are labels, or the surface is that of a mask, see areLabels
  /// The share of the step that lies between the two samples around the surface: as a median .38 for a ball
  /// behind a point spread of .7 samples, .25 to .5 in 25 scans, .62 for the volume fractions of cells
  double sharpness = 0.0;
  std::array<double, 3> sharpnessAlong{}; ///< the same of the edges along each axis
  /// The share of the edges along each axis that lies on the side of greater values; medians.
  std::array<double, 3> innerShareAlong{};
  /// The share of the positions seen from outside where half of the step or more is the edge of a mask,
  /// within two samples of the surface: .80 and .53 for two brains, .49 for masked statistics, at most .27
  /// for 11 other scans.
  double cut = 0.0;
  /// The angle by which smoothing with sharpSmoothing samples turns normals, in radians, and that by which
  /// mostSuggestedSmoothing turns them from there; medians over the positions seen from outside. What bends
  /// within some samples turns by both, what is rough from sample to sample by the first only: .21 and .09
  /// where scans in thick slices were resampled, .09 and .08 for a horse of 48 samples, .28 and .15 for
  /// vessels in a heart.
  double roughness = 0.0;
  double bend = 0.0;
  /// Of labels: the share of the positions beside another label, seen from outside, whose own label has less
  /// than .3 of the labels within three samples: up to .07 for ten atlases of parcels, .08 to .11 for four,
  /// .13 to .32 for seven maps of tissues and tumors, whose borders are noise. 0 where few positions are so.
  double raggedBorders = 0.0;
  /// The slices that have to be there at a time: those around a slice along which thickness is measured.
  static constexpr int slices = 10;
};

/// Estimates the noise around an iso-surface: from the median magnitude of second differences, along all
/// three axes at once so that edges hardly count (Immerkaer, "Fast noise variance estimation", 1996, in three
/// dimensions), of neighborhoods of 3 x 3 x 3 samples that the surface does not intersect. Those of equal
/// values, as in masked air, say nothing. Both sides' variances are averaged.
///
/// Samples enough of a large grid, always the same ones. Axes of one or two samples do not take part.
///
/// @tparam T any of INK_FOR_EACH_SCALAR
/// @param isoValue for NaN, or without a surface, all samples are on one side
template <class T>
NoiseEstimate estimateNoise(const GridField<T>& field, double isoValue);

/// The same, bitwise, for a volume that is not in memory as a whole. Every slice is read once, from the first
/// on, and again with the ones that follow where these need it, at most `slicesAtOnce` per call.
/// @param slicesAtOnce NoiseEstimate::slices or more, or all
/// @throws std::invalid_argument if slicesAtOnce is too small or read returns too few voxels
template <class T>
NoiseEstimate estimateNoise(
  const SliceReader<T>& read, std::array<int, 3> dimensions, int slicesAtOnce, double isoValue);

/// The standard deviation of a Gaussian that makes the normals of an iso-surface smooth enough for lines, and
/// no more: the smallest with which noise turns normals by no more than .02 radians (standard deviation), at
/// a boundary that a point spread of .7 samples blurs. Gray levels that no noise hides count as noise of 1.5
/// of them, but ask for no more than half of the thickness, with which a wall still reaches more than half of
/// its value. Where voxels are longer than wide, it is 2/3 of their length, but no more than 2, nor than
/// half of the thickness, but for 1.65 if few parts are thin: thin parts show what they lose more than
/// slices. What slices are further apart than 3 comes on top of these two, up to 4 in all, where they are
/// thinner than that: where .55 or more of the step lies between two of them, and less of it from .5 on.
///
/// Steps that are sharper than those of scans, as those of volume fractions in simulations of two fluids,
/// show the grid, and so do masks that cut through a gradual transition, where few parts are thin, and what
/// is rough from sample to sample without noise, as scans in thick slices are that were resampled. Of them it
/// is sharpSmoothing, but no more than half of the thickness, of the usual one where the thickness is a
/// single sample, as that of sulci between the labels of a brain, in multiples of the middle one of the three
/// spacings, up to 4: normals of a ball of radius 24 are off by 1.1 degrees then, by 6.0 without (root mean
/// square), and by 2.6 behind a point spread of .7.
///
/// Noise that neighbors share, as of MR that was reconstructed on a finer grid, is seen by how much rougher
/// the surface is than it bends; it asks for up to sharpSmoothing and half of the usual thickness.
///
/// Labels and masks have steps of whole voxels, which no point spread blurs. Of them it is 2, but no more
/// than half of the same thickness, nor than what keeps small parts: a ball of radius 2 is gone with 2; where
/// voxels are longer than wide, it is their length, but no more than 4. Normals of the mask of a sphere of
/// radius 24 then are off by 1.0 degrees (root mean square; 12 without, 3.4 with 1, .6 with 2.5), and with
/// SmoothingTarget::Normals the surface by .02 voxels; with 2.5 those of a tube of radius 4 are worse than
/// with 2 (1.7 and 1.5).
///
/// Where distances are interpolated between slices (`shapeBased`), the slices ask for no more than 3, and
/// those of labels for no more than 2.
///
/// @param spacing the distance of samples along each axis, not 0; signs do not matter
/// @return in multiples of the smallest spacing: 0, or from .3 to mostSuggestedSmoothing, of labels, of
/// slices and of sharp steps up to 4
double suggestSmoothing(const NoiseEstimate& estimate, const glm::dvec3& spacing, bool shapeBased = false);
constexpr double mostSuggestedSmoothing = 2.0;
constexpr double sharpSmoothing = 1.2;

/// Whether distances are the better guess between slices than values, see sliceDistances: where these are
/// far apart and sharp, and where values make terraces. Of labels, which have no values between, they are
/// anyway. Where slices of 3 voxels blur into each other, by a point spread of .7 slices, they are not: F of
/// a bunny's splatting lines is .57 by distances and .67 by values.
bool suggestShapeBasedInterpolation(const NoiseEstimate& estimate, const glm::dvec3& spacing);

/// suggestSmoothing for values that are measured, and for labels.
struct SuggestedDeviations
{
  double ofValues = 0.0;
  double ofLabels = 0.0;
  /// Whether a surface of labels that is smoothed itself keeps its parts: ofLabels is no more than half of
  /// their thickness, or they are thick enough.
  bool keepsLabels = true;

  double get(bool asLabels) const { return asLabels ? this->ofLabels : this->ofValues; }
  /// Takes the most, as for SuggestedSmoothing.
  void add(const SuggestedDeviations& other);
};

/// All that is suggested for a surface.
struct SuggestedSmoothing
{
  SuggestedDeviations byValues = {}; ///< where values are interpolated between slices
  SuggestedDeviations byShapes = {}; ///< where distances are
  bool labels = false;               ///< whether a surface seems to be that of labels
  /// Whether borders between labels are fit to be drawn: few of them are ragged.
  bool clearBorders = true;
  bool shapeBased = false; ///< see suggestShapeBasedInterpolation

  const SuggestedDeviations& get(bool asShapes) const { return asShapes ? this->byShapes : this->byValues; }
  /// Takes what several surfaces ask for, or volumes: the most.
  void add(const SuggestedSmoothing& other);
};
SuggestedSmoothing suggestSmoothings(const NoiseEstimate& estimate, const glm::dvec3& spacing);

} // namespace ink
