// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curvature/PrincipalCurvature.h"
#include "Curvature/TangentPoints.h"

#include <cstddef>
#include <optional>

namespace ink
{

/// A fit and how well it is known.
struct JetFit
{
  PrincipalCurvature curvature;
  CurvatureDerivative derivative; ///< zero for degree 2
  /// The deviation of heights from the polynomial, in world units, with as many degrees of freedom as there
  /// are points beyond the coefficients; infinite without any.
  double residual;
  double reach;      ///< the largest distance in the tangent plane, in world units
  std::size_t count; ///< of points

  /// The deviation of k1 and k2, in 1 / world unit, if heights have independent noise of the size of the
  /// residual: residual / (reach^2 sqrt(count)) times a factor that was measured on spheres with noise, and
  /// is about the same for all sizes of neighborhoods and both degrees.
  double noise() const;
  /// The noise relative to what may be left: what changes the curvature little, compared to its size or,
  /// where the surface is nearly flat, to a bend that can hardly be seen.
  double noiseExcess() const;
};

/// The curvature of the polynomial of degree 2 or 3 in u and v that fits the heights of points best, in the
/// sense of least squares (Cazals and Pouget 2005). It need not pass through the point itself, whose own
/// noise counts no more than that of the others, and the normal need not be exact, since curvature is taken
/// in the metric of the fitted surface.
///
/// Points count less the farther away: by (1 - 0.8 (r / R)^2)^2, R being the reach, so that the fit changes
/// little where the outline of the neighborhood does.
/// @param points the point itself among them
/// @param count how many of the points, from the first on
/// @param degree 2 or 3
/// @return nothing if the points do not determine the polynomial, or a result is not finite
std::optional<JetFit> fitJet(const TangentPoints& points, std::size_t count, int degree);

/// The curvature of u^2 l / 2 + u v m + v^2 n / 2: the normal is taken as exact, and the distances of points
/// from the origin as their distances in the tangent plane, so that points of a sphere give its curvature.
/// Each point counts as the normal curvature in its direction, however far it is. For points that are too few
/// for fitJet; coefficients that they do not determine are zero.
/// @return nothing if none is determined, or one is not finite
std::optional<PrincipalCurvature> fitPinnedQuadric(const TangentPoints& points);

} // namespace ink
