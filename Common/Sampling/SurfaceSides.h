// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ink
{

/// Whether two points near in space are not near on the surface: their normals point away from each other by
/// more than 105 degrees, or the same way but one point is straight above the other. What is unknown, a
/// normal of 0, does not tell points apart.
/// @param likeness the normals' scalar product
/// @param up the square of the one normal's scalar product with the way from one point to the other
/// @param otherUp that of the other normal
/// @param squared distance
inline bool areApart(float likeness, float up, float otherUp, float squared)
{
  constexpr float otherSide = -0.25f;
  constexpr float sameSide = 0.7f;
  constexpr float straightUp = 0.64f;
  const float limit = straightUp * squared;
  // Without branches, for loops over many points.
  return (likeness < otherSide) | ((likeness > sameSide) & (up > limit) & (otherUp > limit));
}

} // namespace ink
