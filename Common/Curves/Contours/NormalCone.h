// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <span>

namespace ink
{

/// A bound of normals and where they stand: each normal n is within an angle of less than 90 degrees from an
/// axis, and at its position p, `lower` <= n.(p - center) <= `upper`. All numbers can be stored as integers
/// of 8 and 16 bits without loss; what bounds is rounded outwards.
struct NormalCone
{
  static constexpr double centerStep = 1.0 / 127.0;
  static constexpr double axisStep = 1.0 / 32767.0;
  static constexpr double axisError = 0.87 / 32767.0; ///< of its length: half a step in three directions
  static constexpr double sineStep = 1.0 / 32767.0;
  static constexpr double offsetStep = 1.0 / 8192.0;

  glm::ivec3 center = glm::ivec3(0); ///< in centerStep, from -127 to 127
  glm::ivec3 axis = glm::ivec3(0);   ///< in axisStep: a length of 1 but for rounding
  int sine = 32767;                  ///< of the angle, in sineStep; the cosine is that of an acute one
  int lower = -32767;                ///< in offsetStep
  int upper = unbounded;             ///< in offsetStep

  static constexpr int unbounded = 32767;
  /// Whether there is a bound; there is none for normals of zero, or in many directions.
  bool bounds() const { return this->upper != unbounded; }

  struct Item
  {
    glm::dvec3 position; ///< of coordinates from -1 to 1
    glm::dvec3 normal;   ///< unit length but for rounding to float, or zero
  };
  static NormalCone around(std::span<const Item> items);
  /// Around all items of cones.
  static NormalCone around(std::span<const NormalCone> cones);
};

} // namespace ink
