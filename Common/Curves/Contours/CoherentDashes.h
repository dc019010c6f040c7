// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Contours/Contours.h"

#include <glm/vec3.hpp>

#include <vector>

namespace ink
{

/// Keeps dashes that are laid by arc length where they were a frame before, on silhouettes, which the eye's
/// motion moves over the surface. The phase of a dash at each point is drawn to that of the nearest point of
/// the frame before, and by an elastic line through its chain to a phase that grows evenly: so dashes give
/// way to each other within about a period where the curve has stretched, or where others have come between,
/// and stay where they were elsewhere.
class CoherentDashes
{
public:
  /// Replaces `arcLength` by the phases times the period, so that dashes by arc length have them; without a
  /// frame before, or a point of it in reach, a chain keeps its own. The contours become the frame before.
  /// @param contours with arc length, of finite positions
  /// @param period of a dash and its gap, more than 0, in world units; closed chains have a whole number of
  ///   periods. Where it differs from that of the frame before, as when the eye comes nearer, chains' dashes
  ///   keep their lengths and are only shifted as a whole
  /// @param reach points of the frame before that are farther do not count, in world units
  void align(Contours& contours, double period, double reach);

  /// Forgets the frame before.
  void reset() { *this = CoherentDashes(); }

private:
  /// A segment of the frame before, with the phases of its ends, in periods.
  struct Segment
  {
    glm::vec3 begin;
    glm::vec3 end;
    float phaseAtBegin;
    float phaseAtEnd;
  };

  glm::dvec3 Origin = glm::dvec3(0.0); ///< of the positions, so that float will do
  std::vector<glm::vec3> Middles;      ///< of the segments
  std::vector<Segment> Segments;
  double Period = 0.0;
};

} // namespace ink
