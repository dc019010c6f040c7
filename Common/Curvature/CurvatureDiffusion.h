// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curvature/MeshCurvature.h"
#include "Curvature/SurfaceRings.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// How well the curvature of a site is known, and for how many passes it is averaged.
struct CurvatureNoise
{
  double deviation = 0.0;  ///< of k1 and k2, in 1 / world unit; finite
  std::uint8_t passes = 0; ///< 0: left as it is
};

/// The passes of diffuseCurvature that divide the noise of fits to two rings by a factor.
///
/// A pass adds to the squared width of what a site's curvature is taken from, and noise of second derivatives
/// falls with the third power of the width: n passes divide it by (1 + 0.8 n)^1.5. The 0.8 follows from means
/// of six neighbors and the site (a variance of 3/7 squared edges, against 0.55 of the fit, taken as a
/// Gaussian of the same noise), and agrees with what was measured on spheres.
/// @param factor 1 or more; may be infinite
double passesToDivideNoise(double factor);

/// The passes that leave of the noise of two rings as much as a fit to this many rings does.
int passesForRings(int rings);

/// Averages curvature over neighbors, pass after pass (Rusinkiewicz 2004 averages triangles at points so):
/// second fundamental forms, as tensors of space, and normals. What many points say costs little more than
/// what few say, as sites share the passes' sums. Neighbors that face away from a site do not count.
///
/// Where curvature varies more among those who are averaged than noise explains, the surface itself is
/// uneven: such a site keeps what it has got before.
/// @param noise one per site
/// @param curvature those of source None take no part
/// @return the uneven sites, ascending
std::vector<std::uint32_t> diffuseCurvature(
  const SurfaceRings& rings, std::span<const CurvatureNoise> noise, MeshCurvature& curvature);

} // namespace ink
