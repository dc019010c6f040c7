// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <limits>
#include <span>

namespace ink
{

/// A bound of normals and where they stand: each normal n is within an angle of less than 90 degrees from an
/// axis, and at its position p, `lower` <= n.(p - center) <= `upper`. Center and axis can be stored in float
/// without loss.
struct NormalCone
{
  glm::dvec3 center = glm::dvec3(0.0);
  glm::dvec3 axis = glm::dvec3(0.0);
  double cosine = 0.0; ///< of the angle
  double sine = 1.0;
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();

  /// Whether there is a bound; there is none for normals of zero, or in many directions.
  bool bounds() const { return this->upper < std::numeric_limits<double>::infinity(); }

  struct Item
  {
    glm::dvec3 position; ///< of a size about 1
    glm::dvec3 normal;   ///< unit length but for rounding to float, or zero
  };
  static NormalCone around(std::span<const Item> items);
  /// Around all items of cones whose numbers have been rounded to float.
  static NormalCone around(std::span<const NormalCone> cones);
};

} // namespace ink
