// SPDX-License-Identifier: BSD-3-Clause
#include "Curvature/ExponentialMapFit.h"

#include "Curvature/LeastNorm.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ink
{

namespace
{

double angleBetween(const glm::dvec3& a, const glm::dvec3& b)
{
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

glm::dvec3 vectorOf(const Eigen::Matrix<double, 5, 3>& matrix, int row)
{
  return { matrix(row, 0), matrix(row, 1), matrix(row, 2) };
}

} // namespace

void unfoldRing(std::span<const glm::dvec3> ring, std::vector<UnfoldedPoint>& result)
{
  result.resize(ring.size());
  double whole = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    result[i].u = whole; // the angles before, for now
    whole += angleBetween(ring[i], ring[(i + 1) % ring.size()]);
  }
  const double flat = 2.0 * std::numbers::pi / whole;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const double angle = flat * result[i].u;
    const double distance = glm::length(ring[i]);
    result[i] = { distance * std::cos(angle), distance * std::sin(angle) };
  }
}

bool fitExponentialMap(
  std::span<const glm::dvec3> ring, std::vector<UnfoldedPoint>& unfolded, PrincipalCurvature& result)
{
  double scale = 0.0;
  for (const glm::dvec3& offset : ring)
  {
    scale = std::max(scale, glm::length(offset));
  }
  if (!(scale > 0.0) || !std::isfinite(scale))
  {
    return false;
  }
  unfoldRing(ring, unfolded);
  Eigen::Matrix<double, 5, 5> matrix = Eigen::Matrix<double, 5, 5>::Zero();
  Eigen::Matrix<double, 5, 3> right = Eigen::Matrix<double, 5, 3>::Zero();
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const double u = unfolded[i].u / scale;
    const double v = unfolded[i].v / scale;
    const Eigen::Matrix<double, 5, 1> row{ u, v, 0.5 * u * u, u * v, 0.5 * v * v };
    const Eigen::RowVector3d q(ring[i].x / scale, ring[i].y / scale, ring[i].z / scale);
    matrix += row * row.transpose();
    right += row * q;
  }
  if (!matrix.allFinite() || !right.allFinite())
  {
    return false;
  }
  const Eigen::Matrix<double, 5, 3> f = leastNormSolution<5, 3>(matrix, right);
  const glm::dvec3 fu = vectorOf(f, 0);
  const glm::dvec3 fv = vectorOf(f, 1);
  const glm::dvec3 across = glm::cross(fu, fv);
  const double size = glm::length(across);
  constexpr double negligible = 1e-12; // of an area that is 1 if the map is isometric
  if (!(size > negligible))
  {
    return false;
  }
  const glm::dvec3 normal = across / size;
  // Eigenvectors in parameters u and v, as in equation 9, hence the axes of the parameter plane. The paper's
  // curvature is positive where the surface bends toward the normal.
  const TangentForm form{ -glm::dot(vectorOf(f, 2), normal) / scale,
    -glm::dot(vectorOf(f, 3), normal) / scale, -glm::dot(vectorOf(f, 4), normal) / scale };
  PrincipalCurvature found = principalCurvature(form, glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0));
  const auto inSpace = [&](const glm::dvec3& d) { return glm::normalize(d.x * fu + d.y * fv); };
  if (std::abs(found.k1) >= std::abs(found.k2))
  {
    found.direction1 = inSpace(found.direction1);
    found.direction2 = glm::normalize(glm::cross(normal, found.direction1));
  }
  else
  {
    found.direction2 = inSpace(found.direction2);
    found.direction1 = glm::normalize(glm::cross(found.direction2, normal));
  }
  if (!std::isfinite(found.k1) || !std::isfinite(found.k2))
  {
    return false;
  }
  result = found;
  return true;
}

} // namespace ink
