// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/NormalCone.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace ink
{

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Bounds what numbers lose by rounding to float, in radians and units of the surface's size.
constexpr double roundingSlack = 1e-6;
/// The cosine of the largest angle of a cone: wider ones would hardly ever be left out.
constexpr double leastCosine = 1e-3;

/// The unit vector, in float; zero for a sum that cancels out.
glm::dvec3 roundedDirection(const glm::dvec3& sum)
{
  const double length = glm::length(sum);
  return length > 1e-9 ? glm::dvec3(glm::vec3(sum / length)) : glm::dvec3(0.0);
}

} // namespace

NormalCone NormalCone::around(std::span<const Item> items)
{
  NormalCone cone;
  glm::dvec3 least(infinity);
  glm::dvec3 most(-infinity);
  glm::dvec3 sum(0.0);
  for (const auto& [position, normal] : items)
  {
    least = glm::min(least, position);
    most = glm::max(most, position);
    sum += normal;
  }
  cone.center = glm::dvec3(glm::vec3(0.5 * (least + most)));
  cone.axis = roundedDirection(sum);
  double sine = 0.0;
  double lower = infinity;
  double upper = -infinity;
  for (const auto& [position, normal] : items)
  {
    if (!(glm::dot(cone.axis, normal) > leastCosine))
    {
      return cone;
    }
    sine = std::max(sine, glm::length(glm::cross(cone.axis, normal)));
    const double offset = glm::dot(normal, position - cone.center);
    lower = std::min(lower, offset);
    upper = std::max(upper, offset);
  }
  cone.sine = std::min(sine, 1.0);
  cone.cosine = std::sqrt(1.0 - cone.sine * cone.sine);
  cone.lower = lower;
  cone.upper = upper;
  return cone;
}

NormalCone NormalCone::around(std::span<const NormalCone> cones)
{
  NormalCone result;
  glm::dvec3 center(0.0);
  glm::dvec3 sum(0.0);
  for (const NormalCone& cone : cones)
  {
    if (!cone.bounds())
    {
      return result;
    }
    center += cone.center / static_cast<double>(cones.size());
    sum += cone.axis;
  }
  result.center = glm::dvec3(glm::vec3(center));
  result.axis = roundedDirection(sum);
  double sine = 0.0;
  double lower = infinity;
  double upper = -infinity;
  for (const NormalCone& cone : cones)
  {
    // sin and cos of the angle between the axes plus the cone's own.
    const double between = glm::length(glm::cross(result.axis, cone.axis));
    const double along = glm::dot(result.axis, cone.axis);
    if (!(along * cone.cosine - between * cone.sine > leastCosine))
    {
      return result;
    }
    sine = std::max(sine, between * cone.cosine + along * cone.sine);
    // n.(p - c') = n.(p - c) + n.(c - c'), the latter bounded over the cone.
    const glm::dvec3 shift = cone.center - result.center;
    const double distance = glm::length(shift);
    const double straight = glm::dot(cone.axis, shift);
    const double aside = glm::length(glm::cross(cone.axis, shift));
    const double most = straight >= distance * cone.cosine
      ? distance
      : std::min(straight * cone.cosine + aside * cone.sine, distance);
    const double least = -straight >= distance * cone.cosine
      ? -distance
      : std::max(straight * cone.cosine - aside * cone.sine, -distance);
    lower = std::min(lower, cone.lower + least);
    upper = std::max(upper, cone.upper + most);
  }
  result.sine = std::min(sine + roundingSlack, 1.0);
  result.cosine = std::sqrt(1.0 - result.sine * result.sine);
  result.lower = lower - roundingSlack;
  result.upper = upper + roundingSlack;
  return result;
}

} // namespace ink
