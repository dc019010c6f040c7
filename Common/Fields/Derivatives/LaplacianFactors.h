// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Grid/GridGeometry.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cmath>

/// Internal to Common/Fields.
namespace ink
{

/// The world Laplacian as a linear combination of second derivatives per sample step: the factors of xx, yy,
/// zz, xy, xz, yz.
struct LaplacianFactors
{
  glm::dvec3 straight;
  double xy;
  double xz;
  double yz;

  explicit LaplacianFactors(const GridGeometry& geometry)
    : straight(of(geometry, 0, 0), of(geometry, 1, 1), of(geometry, 2, 2))
    , xy(of(geometry, 0, 1))
    , xz(of(geometry, 0, 2))
    , yz(of(geometry, 1, 2))
  {
    // Axes count as orthogonal up to rounding.
    constexpr double rounding = 1e-13;
    const auto drop = [](double& mixed, double a, double b)
    { mixed = std::abs(mixed) <= rounding * std::sqrt(a) * std::sqrt(b) ? 0.0 : mixed; };
    drop(this->xy, this->straight.x, this->straight.y);
    drop(this->xz, this->straight.x, this->straight.z);
    drop(this->yz, this->straight.y, this->straight.z);
  }

private:
  static double of(const GridGeometry& geometry, int a, int b)
  {
    glm::dmat3 second(0.0);
    second[a][b] = second[b][a] = 1.0;
    const glm::dmat3 world = geometry.hessianToWorld(second);
    return world[0][0] + world[1][1] + world[2][2];
  }
};

} // namespace ink
