// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SampledMeshes.h"

#include "Core/Hash.h"
#include "Curves/Streamlines/LineField.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace ink::test
{

/// A mesh of a shape whose lines of curvature are known, with the exact directions at its points.
struct Shape
{
  Mesh mesh;
  std::vector<glm::vec3> normals;
  std::vector<glm::dvec3> maximum; ///< the direction of the larger curvature
  std::vector<glm::dvec3> minimum;
};

/// A torus around the z axis. Lines of maximum curvature are circles of constant angle around the axis, those
/// of minimum curvature have a constant angle around the tube.
struct TorusShape
{
  double radius = 2.0;
  double tube = 0.7;

  Shape sample(int columns, int rows) const
  {
    Shape shape{ torus(this->radius, this->tube, columns, rows), {}, {}, {} };
    for (const glm::dvec3& p : shape.mesh.points)
    {
      const double around = std::atan2(p.y, p.x);
      const double across = this->across(p);
      const glm::dvec3 out(std::cos(around), std::sin(around), 0.0);
      const glm::dvec3 up(0.0, 0.0, 1.0);
      shape.normals.emplace_back(std::cos(across) * out + std::sin(across) * up);
      shape.maximum.push_back(-std::sin(across) * out + std::cos(across) * up);
      shape.minimum.emplace_back(-out.y, out.x, 0.0);
    }
    return shape;
  }
  /// The nearest point of the torus.
  glm::dvec3 onto(const glm::dvec3& p) const
  {
    const glm::dvec3 middle = this->radius * glm::normalize(glm::dvec3(p.x, p.y, 0.0));
    return middle + this->tube * glm::normalize(p - middle);
  }
  double across(const glm::dvec3& p) const { return std::atan2(p.z, std::hypot(p.x, p.y) - this->radius); }
  static double difference(double a, double b)
  {
    return std::abs(std::remainder(a - b, 2.0 * std::numbers::pi));
  }
  /// How far a point is from the line of curvature through another one, along the surface.
  double deviation(const glm::dvec3& p, const glm::dvec3& from, bool maximum) const
  {
    return maximum ? difference(std::atan2(p.y, p.x), std::atan2(from.y, from.x)) * std::hypot(p.x, p.y)
                   : difference(this->across(p), this->across(from)) * this->tube;
  }
};

/// An ellipsoid of three different half axes, longest first. Its lines of curvature are its intersections
/// with the quadrics of the same foci (Dupin), x^2 / (a^2 - l) + y^2 / (b^2 - l) + z^2 / (c^2 - l) = 1.
struct EllipsoidShape
{
  glm::dvec3 axes{ 3.0, 2.0, 1.2 };

  /// The parameters of both quadrics through a point, the smaller one (b^2 > l > c^2) first.
  glm::dvec2 parameters(const glm::dvec3& p) const
  {
    // Of the cubic in l, 0 is a root as the point is on the ellipsoid; the others are those of a quadratic.
    const glm::dvec3 s = this->axes * this->axes;
    const glm::dvec3 q = p * p;
    const double sum = s.x + s.y + s.z - q.x - q.y - q.z;
    const double product =
      s.x * s.y + s.y * s.z + s.z * s.x - q.x * (s.y + s.z) - q.y * (s.x + s.z) - q.z * (s.x + s.y);
    const double root = std::sqrt(std::max(0.25 * sum * sum - product, 0.0));
    return { 0.5 * sum - root, 0.5 * sum + root };
  }
  /// A point of the ellipsoid in the same direction.
  glm::dvec3 onto(const glm::dvec3& p) const { return p / glm::length(p / this->axes); }

  Shape sample(int columns, int rows) const
  {
    Shape shape;
    // Poles of the grid on the longest axis.
    shape.mesh = test::sphere(columns, rows);
    for (glm::dvec3& p : shape.mesh.points)
    {
      p = glm::dvec3(p.z, p.x, p.y) * this->axes;
      const glm::dvec3 s = this->axes * this->axes;
      // The second fundamental form of x^2 / a^2 + y^2 / b^2 + z^2 / c^2 = 1, but for a factor.
      const glm::dvec3 normal = glm::normalize(p / s);
      const glm::dvec3 axis1 = glm::normalize(
        glm::cross(normal, std::abs(normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
      const glm::dvec3 axis2 = glm::cross(normal, axis1);
      const double l = glm::dot(axis1 / s, axis1);
      const double m = glm::dot(axis1 / s, axis2);
      const double n = glm::dot(axis2 / s, axis2);
      const double angle = 0.5 * std::atan2(2.0 * m, l - n);
      shape.normals.emplace_back(normal);
      shape.maximum.push_back(std::cos(angle) * axis1 + std::sin(angle) * axis2);
      shape.minimum.push_back(std::cos(angle) * axis2 - std::sin(angle) * axis1);
    }
    return shape;
  }
  /// How far a point is from the line of curvature through another one, along the surface: the difference of
  /// the constant parameter over its slope.
  double deviation(const glm::dvec3& point, const glm::dvec3& from, bool maximum) const
  {
    const glm::dvec3 p = this->onto(point);
    const auto constant = [&](const glm::dvec3& q)
    {
      const glm::dvec2 both = this->parameters(q);
      return maximum ? both.y : both.x;
    };
    const double here = constant(p);
    const glm::dvec3 s = this->axes * this->axes - here;
    // Implicit differentiation of the quadric's equation.
    const double slope = 2.0 * glm::length(p / s) / std::abs(glm::dot(p / s, p / s));
    return std::abs(here - constant(this->onto(from))) / slope;
  }
};

inline LineField fieldOf(const Shape& shape, bool maximum = true)
{
  return { maximum ? shape.maximum : shape.minimum, {}, {} };
}

} // namespace ink::test
