// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ink
{

/// The square of the cosine between a normal and the way to another point from which on that point is
/// directly above.
constexpr float straightUp = 0.64f;

/// Whether two points that are close in space are on different sides or sheets of the surface: their normals
/// differ by more than 105 degrees, or agree while one point is directly above the other. An unknown normal,
/// 0, never separates points.
/// @param likeness the normals' dot product
/// @param up the square of one normal's dot product with the vector between the points
/// @param otherUp the same for the other normal
/// @param squared the squared distance
inline bool areApart(float likeness, float up, float otherUp, float squared)
{
  constexpr float otherSide = -0.25f;
  constexpr float sameSide = 0.7f;
  const float limit = straightUp * squared;
  // Branchless, so that loops over many points vectorize.
  return (likeness < otherSide) | ((likeness > sameSide) & (up > limit) & (otherUp > limit));
}

} // namespace ink
