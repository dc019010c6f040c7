// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Visibility/DepthImage.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace ink
{

/// The surfaces that hide curves, as a camera sees them.
struct CurveOccluders
{
  DepthImage image;
  /// clip z = [0] * view z + [1], clip w = [2] * view z + [3]; view z is negative in front of the eye
  double depthToClip[4] = { -1.0, 0.0, 0.0, 1.0 };
  double pixel = 1.0; ///< view units per pixel of the image where clip w is 1
  /// View units that a curve on a surface may lie behind it.
  double tolerance = 0.0;
  /// Pixels of the image that such a curve may lie within the outline of that surface, at most.
  double withinOutline = 0.0;
};

/// How far the image has to go on beyond a part of a picture for the runs there to be those of the whole, for
/// CurveOccluders::withinOutline.
double outlineMargin(double withinOutline);

/// A point of a curve as the same camera sees it.
struct CurvePoint
{
  glm::dvec4 clip;              ///< OpenGL's clip coordinates
  double radialCurvature = 0.0; ///< of a surface's silhouette: negative where the surface itself hides it
  /// Of a surface's silhouette: the direction of its normal in the image, of length 1 or 0 if it is not
  /// known. The surface itself lies on one side of the curve, and on the other what it hides, if anything.
  glm::dvec2 normal = glm::dvec2(0.0);
};

/// A part of a curve between two positions on it. Position n + t lies at the fraction t of segment n, from
/// point n to the next; beyond the number of segments a closed curve goes on with its first.
struct CurveRun
{
  double from;
  double to;
  bool hidden;
};

/// Which parts of a curve surfaces hide, decided along the curve: samples a pixel apart are compared with the
/// depth image, each with the 8 neighbors of its pixel, too (Isenberg et al. 2002, section 4): a silhouette
/// lies where a pixel beside it may show its own surface a little nearer. A sample is hidden where all nine
/// are nearer, or its own pixel is nearer by far. Where a surface is flat across its silhouette, and its
/// normals are not quite its own, it hides the silhouette by far, and yet by a pixel or two only: there,
/// pixels farther along the normal are compared as well. With a tolerance, a curve may be meant for the
/// outline of a surface that hides it, by up to three times the tolerance: where it goes along within that
/// outline, by no more than .3 of the tolerance and `withinOutline`, from where it is seen to where it is
/// seen again, or for four times that, it is visible. Runs of samples shorter than `leastRun` join their
/// neighbors, so that a curve that grazes a surface is not dotted, but where they go on beyond the image:
/// what it shows far from its border is the same in a larger one.
///
/// @param closed the last point is connected to the first, which is not repeated
/// @param leastRun pixels of the image
/// @return runs in the curve's order that cover all of it, alternately visible and hidden; what the image
///   does not show goes on as what it is connected to, or else is visible. Empty for less than two points.
/// @throws std::invalid_argument as DepthImage::check
std::vector<CurveRun> findVisibleRuns(
  std::span<const CurvePoint> points, bool closed, const CurveOccluders& occluders, double leastRun);

} // namespace ink
