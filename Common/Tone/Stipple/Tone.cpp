// SPDX-License-Identifier: BSD-3-Clause
#include "Tone/Stipple/Tone.h"

#include "Tone/Power.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ink::stipple
{

namespace
{

/// The cosine of the angle between a normal and the direction to the eye.
float eyeCosine(const Tone::View& view, const Tone::Element& element)
{
  if (view.parallel)
  {
    return element.normal.z;
  }
  const float length = glm::length(element.position);
  return length > 0.0f ? -glm::dot(element.normal, element.position) / length : 1.0f;
}

/// The largest cosine of the angles between a normal and the lights.
float lightCosine(std::span<const Light> lights, const glm::vec3& position, const glm::vec3& normal)
{
  float most = -1.0f;
  for (const Light& light : lights)
  {
    const glm::vec3 towards = glm::vec3(light.position) - light.position.w * position;
    const float length = glm::length(towards);
    most = std::max(most, length > 0.0f ? glm::dot(normal, towards) / length : 1.0f);
  }
  return std::min(most, 1.0f);
}

} // namespace

Tone::Mark Tone::mark(const View& view, std::span<const Light> lights, const Element& element, int rank) const
{
  const float distanceFromEye = -element.position.z;
  const float depth = (view.middle - distanceFromEye) / view.halfRange;
  glm::vec3 normal = element.normal;
  float cosine = eyeCosine(view, element);
  const bool seen = this->isSeen(cosine);
  if (this->surface)
  {
    normal = cosine < 0.0f ? -normal : normal;
    cosine = std::abs(cosine);
  }

  float factors = 1.0f;
  if (!this->surface)
  {
    const float value = power(element.value, this->valueEffect);
    factors *= this->boundary.factor(value, element.gradientMagnitude);
    factors *= this->silhouette.factor(value, cosine);
  }
  const float byDistance =
    view.parallel ? 1.0f : this->resolution.distanceFactor(distanceFromEye, view.nearest);
  factors *= this->resolution.slantFactor(std::abs(cosine));
  factors *= this->lighting.factor(this->lighting.lit(lights, element.position, normal));
  factors *= this->distance.factor(depth);
  factors *= this->surface ? 1.0f : this->interior.factor(element.gradientMagnitude);

  const float room = view.maximumStipples / view.listed * byDistance;
  Mark mark;
  mark.tone = element.listLength * (this->growWithZoom ? std::min(room, 1.0f) : room) * factors;
  mark.opacity = seen && static_cast<float>(rank) < element.listLength
    ? this->smallElements.part(mark.tone, rank, element.random, view.smallness)
    : 0.0f;
  mark.diameter = this->diameter * this->distance.sizeFactor(depth);
  mark.diameter *= this->surface ? 1.0f : this->interior.sizeFactor(element.gradientMagnitude);
  mark.diameter *= this->growWithZoom ? std::sqrt(std::max(room, 1.0f)) : 1.0f;
  if (this->fadeBySize && mark.opacity > 0.0f)
  {
    mark.diameter *= std::sqrt(mark.opacity);
    mark.opacity = 1.0f;
  }
  mark.opacity *= element.alpha;
  mark.color = this->warmCool.color(element.color, lightCosine(lights, element.position, normal), depth);
  return mark;
}

bool Tone::isSeen(float cosine) const
{
  return this->surface ? this->twoSided || cosine > 0.0f : this->lighting.faces(cosine);
}

float Tone::mostTone(const View& view, float largestValue, float largestGradient, float longestList,
  float nearestDistance, float farthestDistance, const Directions& directions) const
{
  if (!this->isSeen(directions.mostCosine))
  {
    return 0.0f;
  }
  const bool bothSides = directions.leastCosine < 0.0f && directions.mostCosine > 0.0f;
  const float ends[2] = { std::abs(directions.leastCosine), std::abs(directions.mostCosine) };
  const float leastSlant = bothSides ? 0.0f : std::min(ends[0], ends[1]);
  const float mostSlant = std::max(ends[0], ends[1]);
  float factors =
    this->resolution.slantFactor(this->resolution.slantExponent >= 0.0f ? mostSlant : leastSlant);
  factors *= this->lighting.factor(this->lighting.lightInk ? directions.mostLit : directions.leastLit);
  if (!this->surface)
  {
    const float value = power(largestValue, this->valueEffect);
    factors *= this->boundary.factor(value, largestGradient);
    factors *= this->silhouette.factor(value, this->silhouette.gain >= 0.0f ? leastSlant : mostSlant);
    factors *= this->interior.factor(largestGradient);
  }
  factors *= this->distance.factor((view.middle - nearestDistance) / view.halfRange);
  // It falls with the distance up to d_0, and on with a k_rc that is not positive.
  const float byDistance = view.parallel
    ? 1.0f
    : std::max(this->resolution.distanceFactor(nearestDistance, view.nearest),
        this->resolution.distanceFactor(farthestDistance, view.nearest));
  const float room = view.maximumStipples / view.listed * byDistance;
  return longestList * (this->growWithZoom ? std::min(room, 1.0f) : room) * factors;
}

float Tone::largestDiameter(const View& view) const
{
  float most = this->diameter * this->distance.sizeFactor(1.0f);
  if (this->growWithZoom)
  {
    // Only with a positive k_rc may there be more room farther away.
    const bool known = view.parallel || !this->resolution.on || this->resolution.exponent <= 0.0f;
    const float byDistance =
      view.parallel ? 1.0f : this->resolution.distanceFactor(view.closest, view.nearest);
    most *= known ? std::sqrt(std::max(view.maximumStipples / view.listed * byDistance, 1.0f))
                  : std::numeric_limits<float>::infinity();
  }
  return most;
}

} // namespace ink::stipple
