// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <span>

namespace ink
{

/// Directions without a sign at the points of a mesh, tangent to it: a line field, or with `others` a cross
/// field.
struct LineField
{
  std::span<const glm::dvec3> directions; ///< one per point, unit length; zero where undefined
  /// Empty, or one per point, unit length: at right angles to `directions`. Then a line follows whichever of
  /// the two is closer to its own direction, so that it does not matter which is called which.
  std::span<const glm::dvec3> others;
  /// Empty, or one per point, in [0, 1]: how little directions are defined there (ink::umbilicMeasure).
  std::span<const float> umbilics;

  /// Of the directions at a point the one closest to a vector, with its sign (Rössl et al. 2000, section 2.2,
  /// where directions are flipped beyond an angle of pi; pi / 2 is meant).
  glm::dvec3 along(std::size_t point, const glm::dvec3& vector) const
  {
    glm::dvec3 best = this->directions[point];
    double likeness = glm::dot(best, vector);
    if (!this->others.empty())
    {
      const double other = glm::dot(this->others[point], vector);
      if (other * other > likeness * likeness)
      {
        best = this->others[point];
        likeness = other;
      }
    }
    return likeness < 0.0 ? -best : best;
  }
};

} // namespace ink
