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

constexpr double beyond = 32767.0; // any coordinate, and any offset of them
/// The cosine of the largest angle of a cone: wider ones would hardly ever be left out, and their cosines
/// would be too inexact where sines are in float.
constexpr double leastCosine = 0.1;

/// Of any vector but zero, the direction as it is stored; zero for a sum that cancels out.
glm::ivec3 storedDirection(const glm::dvec3& sum)
{
  const double length = glm::length(sum);
  return length > 1e-9 ? glm::ivec3(glm::round(sum / (length * NormalCone::axisStep))) : glm::ivec3(0);
}

glm::dvec3 directionOf(const glm::ivec3& stored)
{
  return stored == glm::ivec3(0) ? glm::dvec3(0.0) : glm::normalize(glm::dvec3(stored));
}

glm::ivec3 storedCenter(const glm::dvec3& center)
{
  return glm::clamp(glm::ivec3(glm::round(center / NormalCone::centerStep)), -127, 127);
}

glm::dvec3 centerOf(const NormalCone& cone)
{
  return NormalCone::centerStep * glm::dvec3(cone.center);
}

double cosineOf(double sine)
{
  return std::sqrt(1.0 - sine * sine);
}

/// Fills in what has been bounded, rounded outwards, unless that is more than can be stored.
NormalCone bounded(NormalCone cone, double sine, double lower, double upper)
{
  constexpr double slack = 1e-3; // of a step, for rounding in double
  const double steps = std::ceil(sine / NormalCone::sineStep + slack);
  const double low = std::floor(lower / NormalCone::offsetStep - slack);
  const double high = std::ceil(upper / NormalCone::offsetStep + slack);
  if (low > -NormalCone::unbounded && high < NormalCone::unbounded)
  {
    cone.sine = static_cast<int>(std::min(steps, 32767.0));
    cone.lower = static_cast<int>(low);
    cone.upper = static_cast<int>(high);
  }
  return cone;
}

} // namespace

NormalCone NormalCone::around(std::span<const Item> items)
{
  NormalCone cone;
  glm::dvec3 least(beyond);
  glm::dvec3 most(-beyond);
  glm::dvec3 sum(0.0);
  for (const auto& [position, normal] : items)
  {
    least = glm::min(least, position);
    most = glm::max(most, position);
    sum += normal;
  }
  cone.center = storedCenter(0.5 * (least + most));
  cone.axis = storedDirection(sum);
  const glm::dvec3 center = centerOf(cone);
  const glm::dvec3 axis = directionOf(cone.axis);
  double sine = 0.0;
  double lower = beyond;
  double upper = -beyond;
  for (const auto& [position, normal] : items)
  {
    if (!(glm::dot(axis, normal) > leastCosine))
    {
      return cone;
    }
    sine = std::max(sine, glm::length(glm::cross(axis, normal)));
    const double offset = glm::dot(normal, position - center);
    lower = std::min(lower, offset);
    upper = std::max(upper, offset);
  }
  return bounded(cone, sine, lower, upper);
}

NormalCone NormalCone::around(std::span<const NormalCone> cones)
{
  NormalCone result;
  glm::dvec3 centers(0.0);
  glm::dvec3 sum(0.0);
  for (const NormalCone& cone : cones)
  {
    if (!cone.bounds())
    {
      return result;
    }
    centers += centerOf(cone) / static_cast<double>(cones.size());
    sum += directionOf(cone.axis);
  }
  result.center = storedCenter(centers);
  result.axis = storedDirection(sum);
  const glm::dvec3 axis = directionOf(result.axis);
  double sine = 0.0;
  double lower = beyond;
  double upper = -beyond;
  for (const NormalCone& cone : cones)
  {
    // sin and cos of the angle between the axes plus the cone's own.
    const glm::dvec3 coneAxis = directionOf(cone.axis);
    const double coneSine = cone.sine * sineStep;
    const double coneCosine = cosineOf(coneSine);
    const double between = glm::length(glm::cross(axis, coneAxis));
    const double along = glm::dot(axis, coneAxis);
    if (!(along * coneCosine - between * coneSine > leastCosine))
    {
      return result;
    }
    sine = std::max(sine, between * coneCosine + along * coneSine);
    // n.(p - c') = n.(p - c) + n.(c - c'), the latter bounded over the cone.
    const glm::dvec3 shift = centerOf(cone) - centerOf(result);
    const double distance = glm::length(shift);
    const double straight = glm::dot(coneAxis, shift);
    const double aside = glm::length(glm::cross(coneAxis, shift));
    const double most = straight >= distance * coneCosine
      ? distance
      : std::min(straight * coneCosine + aside * coneSine, distance);
    const double least = -straight >= distance * coneCosine
      ? -distance
      : std::max(straight * coneCosine - aside * coneSine, -distance);
    lower = std::min(lower, cone.lower * offsetStep + least);
    upper = std::max(upper, cone.upper * offsetStep + most);
  }
  return bounded(result, sine, lower, upper);
}

} // namespace ink
