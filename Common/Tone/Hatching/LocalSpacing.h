// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "PointSampling/AreaSamples.h"
#include "Tone/Hatching/StrokeWidth.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace ink::hatching
{

/// The polylines of a family of strokes, in units of the mean distance of all of them.
struct FamilyStrokes
{
  std::vector<glm::vec3> points; ///< one stroke's after the other's
  std::vector<glm::vec3> normals;
  std::vector<std::uint32_t> begins; ///< of each stroke, and last the number of points
  std::vector<float> priorities;     ///< one per stroke
};

/// How far strokes are from each other around each of their points, relative to their mean distance: the area
/// there over their length there, both weighted by a kernel that reaches two such distances; for each of the
/// fractions of them that may be drawn. With widths that are so much larger, a gray is the same where real
/// lines are closer or wider apart than they are meant to be. Within bounds: where there are hardly any
/// lines, a few strokes are not made to stand for them.
///
/// The result is the same for any number of threads.
/// @param surface in the same units
/// @return one per point; evenSpacing where a point or a normal is not finite, or all of that is when stopped
std::vector<SpacingRatios> localSpacing(
  const FamilyStrokes& strokes, AreaSamples surface, const Progress& progress = {});

} // namespace ink::hatching
