#pragma once

#include "Fields/Field.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

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

static_assert(Field<Plane>);
static_assert(Field<Sphere>);
static_assert(Field<Torus>);

} // namespace ink::testing
