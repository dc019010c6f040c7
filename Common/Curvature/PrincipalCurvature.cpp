// SPDX-License-Identifier: BSD-3-Clause
#include "Curvature/PrincipalCurvature.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace ink
{

glm::dvec3 PrincipalCurvature::normal() const
{
  return glm::cross(this->direction1, this->direction2);
}

double PrincipalCurvature::along(const glm::dvec3& direction) const
{
  const double a = glm::dot(direction, this->direction1);
  const double b = glm::dot(direction, this->direction2);
  return (this->k1 * a * a + this->k2 * b * b) / (a * a + b * b);
}

double PrincipalCurvature::umbilicMeasure(double negligible) const
{
  return ink::umbilicMeasure(this->k1, this->k2, negligible);
}

double umbilicMeasure(double k1, double k2, double negligible)
{
  const double difference = std::max(k1 - k2 - negligible, 0.0);
  const double size = std::abs(k1) + std::abs(k2) + negligible;
  // The difference is at most the size, but for rounding.
  return difference > 0.0 ? std::max(1.0 - difference / size, 0.0) : 1.0;
}

namespace
{

/// std::hypot, at a fraction of its time where squares are numbers of full precision.
double lengthOf(double x, double y)
{
  constexpr double least = 1e-280;
  constexpr double most = 1e280;
  const double square = x * x + y * y;
  return square > least && square < most ? std::sqrt(square) : std::hypot(x, y);
}

} // namespace

PrincipalCurvature principalCurvature(
  const TangentForm& form, const glm::dvec3& axis1, const glm::dvec3& axis2)
{
  const double mean = 0.5 * (form.l + form.n);
  const double half = 0.5 * (form.l - form.n);
  const double radius = lengthOf(half, form.m);
  // Direction 1 is turned from axis 1 by half the angle of (half, m); the larger of its cosine and sine is
  // found first, so that no digits cancel.
  double cosine = 1.0;
  double sine = 0.0;
  if (radius > 0.0)
  {
    const double larger = std::sqrt(0.5 * (1.0 + std::abs(half) / radius));
    const double smaller = 0.5 * form.m / (radius * larger);
    cosine = half >= 0.0 ? larger : std::abs(smaller);
    sine = half >= 0.0 ? smaller : std::copysign(larger, form.m);
  }
  return { mean + radius, mean - radius, cosine * axis1 + sine * axis2, cosine * axis2 - sine * axis1 };
}

std::array<glm::dvec3, 2> tangentAxes(const glm::dvec3& normal)
{
  // The coordinate axis that is farthest from the normal.
  const glm::dvec3 size(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
  const glm::dvec3 axis = size.x <= size.y && size.x <= size.z ? glm::dvec3(1.0, 0.0, 0.0)
    : size.y <= size.z                                         ? glm::dvec3(0.0, 1.0, 0.0)
                                                               : glm::dvec3(0.0, 0.0, 1.0);
  const glm::dvec3 axis1 = glm::normalize(glm::cross(axis, normal));
  return { axis1, glm::cross(normal, axis1) };
}

} // namespace ink
