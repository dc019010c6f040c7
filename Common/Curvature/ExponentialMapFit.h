// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curvature/PrincipalCurvature.h"

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace ink
{

/// A neighbor in the plane that the 1-ring of a point is unfolded to.
struct UnfoldedPoint
{
  double u;
  double v;
};

/// The exponential map of Rössl et al. (2000, equations 1 and 2): neighbors keep their distances from the
/// origin; the angles between them are scaled so that they sum to 2 pi. The first one is on the u axis.
/// @param ring offsets from the point, in order around it; those of length zero are mapped to zero
/// @param result as many as `ring`
void unfoldRing(std::span<const glm::dvec3> ring, std::vector<UnfoldedPoint>& result);

/// The estimator of Rössl et al. (2000, section 2.1): a Taylor polynomial of degree 2 from the unfolded ring
/// to space through the point itself (equations 3 to 5), its second fundamental form for an identity as the
/// first (6, 7), and the directions in space (10). The direction of the larger |k| is theirs, the other one
/// orthogonal to it.
///
/// Equation 5 has three cases, for n < 5, n = 5 and n > 5 neighbors; all are the pseudoinverse, which also
/// covers rings that do not determine the polynomial. Lengths are divided by the ring's largest, because the
/// solution of least norm, n < 5, depends on the unit. For equation 9 see principalCurvature.
///
/// @param ring offsets from the point, of a closed fan, counterclockwise seen from outside
/// @param unfolded scratch space
/// @return whether there is a result; not if the ring has no size or no normal
bool fitExponentialMap(
  std::span<const glm::dvec3> ring, std::vector<UnfoldedPoint>& unfolded, PrincipalCurvature& result);

} // namespace ink
