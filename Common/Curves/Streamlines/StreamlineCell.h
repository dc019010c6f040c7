// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Streamlines/LineField.h"
#include "Mesh/MeshNavigation.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace ink
{

/// A triangle with the directions of its corners, turned to that of the line.
struct StreamlineCell
{
  TriangleChart chart;
  std::array<glm::dvec2, 3> corners; ///< directions, projected
  double adaptiveStep;               ///< Rössl et al. 2000, equation 15
  bool isSingular;

  /// @param own the triangle's chart
  StreamlineCell(const MeshNavigation& mesh, const LineField& field, std::uint32_t triangle,
    const TriangleChart& own, const glm::dvec3& heading)
    : chart(own)
  {
    const Triangle& points = mesh.mesh().triangles[triangle];
    std::array<glm::dvec3, 3> directions;
    for (std::size_t i = 0; i < 3; ++i)
    {
      directions[i] = field.along(points[i], heading);
      this->corners[i] = { glm::dot(directions[i], this->chart.axisX),
        glm::dot(directions[i], this->chart.axisY) };
    }
    double turns = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      turns += std::acos(std::clamp(glm::dot(directions[i], directions[(i + 1) % 3]), 0.0, 1.0));
    }
    this->adaptiveStep = this->chart.perimeter() / (2.0 * (1.0 + turns) * (1.0 + turns));
    const glm::dvec3 around =
      field.along(points[0], field.along(points[2], field.along(points[1], directions[0])));
    this->isSingular = around != directions[0];
  }

  StreamlineCell(
    const MeshNavigation& mesh, const LineField& field, std::uint32_t triangle, const glm::dvec3& heading)
    : StreamlineCell(mesh, field, triangle, mesh.chart(triangle), heading)
  {
  }

  /// Equation 12; zero where it is not defined.
  glm::dvec2 direction(const glm::dvec3& weights) const
  {
    const glm::dvec2 sum =
      weights.x * this->corners[0] + weights.y * this->corners[1] + weights.z * this->corners[2];
    const double size = glm::length(sum);
    return size > 1e-6 ? sum / size : glm::dvec2(0.0);
  }

  glm::dvec3 lift(const glm::dvec2& v) const { return v.x * this->chart.axisX + v.y * this->chart.axisY; }

  glm::dvec3 moved(const glm::dvec3& weights, const glm::dvec2& by) const
  {
    return weights + this->chart.rates(by.x, by.y);
  }

  /// The classical Runge-Kutta step.
  glm::dvec2 rungeKutta(const glm::dvec3& weights, const glm::dvec2& first, double step) const
  {
    const glm::dvec2 second = this->direction(this->moved(weights, 0.5 * step * first));
    const glm::dvec2 third = this->direction(this->moved(weights, 0.5 * step * second));
    const glm::dvec2 fourth = this->direction(this->moved(weights, step * third));
    return step / 6.0 * (first + 2.0 * second + 2.0 * third + fourth);
  }
};

} // namespace ink
