// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Field.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include <cmath>

namespace ink::testing
{

/// (p - point) . normal
struct Plane
{
  glm::dvec3 point;
  glm::dvec3 normal;

  double value(const glm::dvec3& p) const { return glm::dot(p - this->point, this->normal); }
  glm::dvec3 gradient(const glm::dvec3&) const { return this->normal; }
  glm::dmat3 hessian(const glm::dvec3&) const { return glm::dmat3(0.0); }
  double distance(const glm::dvec3& p) const { return this->value(p) / glm::length(this->normal); }
};

/// The distance from a sphere, positive outside.
struct Sphere
{
  glm::dvec3 center;
  double radius;

  double value(const glm::dvec3& p) const { return glm::length(p - this->center) - this->radius; }
  glm::dvec3 gradient(const glm::dvec3& p) const { return glm::normalize(p - this->center); }
  glm::dmat3 hessian(const glm::dvec3& p) const
  {
    const glm::dvec3 n = this->gradient(p);
    return (glm::dmat3(1.0) - glm::outerProduct(n, n)) / glm::length(p - this->center);
  }
  double distance(const glm::dvec3& p) const { return this->value(p); }
};

/// The distance from a torus around the z axis, positive outside.
struct Torus
{
  double major;
  double minor;

  double value(const glm::dvec3& p) const { return glm::length(p - this->nearestOnCircle(p)) - this->minor; }
  glm::dvec3 gradient(const glm::dvec3& p) const { return glm::normalize(p - this->nearestOnCircle(p)); }
  glm::dmat3 hessian(const glm::dvec3& p) const
  {
    // One principal direction runs around the circle, the other around the tube.
    const glm::dvec3 n = this->gradient(p);
    const glm::dvec3 around = glm::normalize(glm::dvec3(-p.y, p.x, 0.0));
    const glm::dvec3 aroundTube = glm::cross(n, around);
    const double fromAxis = glm::length(glm::dvec2(p));
    const double fromCircle = glm::length(p - this->nearestOnCircle(p));
    return glm::outerProduct(around, around) * ((fromAxis - this->major) / (fromAxis * fromCircle)) +
      glm::outerProduct(aroundTube, aroundTube) / fromCircle;
  }
  double distance(const glm::dvec3& p) const { return this->value(p); }

private:
  glm::dvec3 nearestOnCircle(const glm::dvec3& p) const
  {
    return glm::dvec3(glm::normalize(glm::dvec2(p)) * this->major, 0.0);
  }
};

/// The test signal of Marschner and Lobb (1994), with their frequency 6 and depth 0.25 for -1 <= x, y, z <=
/// 1: from 0 to 1, and hard to reconstruct from 40^3 samples.
struct MarschnerLobb
{
  double frequency = 6.0;
  double depth = 0.25;

  double value(const glm::dvec3& p) const
  {
    return (1.0 - std::sin(0.5 * pi * p.z) + this->depth * (1.0 + this->wave(glm::length(glm::dvec2(p))))) /
      (2.0 * (1.0 + this->depth));
  }
  glm::dvec3 gradient(const glm::dvec3& p) const
  {
    // The wave is cos(u) with u = 2 pi f cos(pi r / 2).
    const double r = glm::length(glm::dvec2(p));
    const double u = 2.0 * pi * this->frequency * std::cos(0.5 * pi * r);
    const double slope = std::sin(u) * pi * pi * this->frequency * std::sin(0.5 * pi * r);
    const glm::dvec2 outward = r > 0.0 ? glm::dvec2(p) / r : glm::dvec2(0.0);
    return glm::dvec3(this->depth * slope * outward, -0.5 * pi * std::cos(0.5 * pi * p.z)) /
      (2.0 * (1.0 + this->depth));
  }

private:
  static constexpr double pi = 3.141592653589793;
  double wave(double r) const { return std::cos(2.0 * pi * this->frequency * std::cos(0.5 * pi * r)); }
};

static_assert(Field<Plane>);
static_assert(Field<Sphere>);
static_assert(Field<Torus>);

} // namespace ink::testing
