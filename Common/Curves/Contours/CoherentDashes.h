// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Contours/Contours.h"

#include <glm/vec3.hpp>

#include <vector>

namespace ink
{

/// Keeps dashes that are laid by arc length where they were a frame before, on silhouettes, which the eye's
/// motion moves over the surface: each chain's arc length is shifted as a whole, by what brings the phases of
/// its dashes closest to those of the nearest points of the frame before, in the mean of the angles 2 pi
/// phase, weighted by length. What then still slides is what stretches.
class CoherentDashes
{
public:
  /// Shifts `arcLength` by up to a period; without a frame before, not at all. The contours become the frame
  /// before.
  /// @param contours with arc length, of finite positions
  /// @param period of a dash and its gap, more than 0, in world units; closed chains have a whole number of
  ///   periods
  /// @param reach points of the frame before that are farther do not count, in world units
  void align(Contours& contours, double period, double reach);

  /// Forgets the frame before.
  void reset() { *this = CoherentDashes(); }

private:
  glm::dvec3 Origin = glm::dvec3(0.0); ///< of the positions, so that float will do
  std::vector<glm::vec3> Positions;    ///< the middles of the segments of the frame before
  std::vector<float> Phases;           ///< there, in periods
};

} // namespace ink
