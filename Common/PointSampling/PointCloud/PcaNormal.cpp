// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/PointCloud/PcaNormal.h"

#include <Eigen/Eigenvalues>
#include <glm/geometric.hpp>

namespace ink
{

namespace
{

// An eigenvalue below this fraction of the largest counts as 0.
constexpr double flat = 1e-10;

} // namespace

glm::vec3 pcaNormal(std::span<const glm::vec3> points, std::span<const std::uint32_t> near)
{
  glm::dvec3 mean(0.0);
  for (const std::uint32_t i : near)
  {
    mean += glm::dvec3(points[i]) / static_cast<double>(near.size());
  }
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const std::uint32_t i : near)
  {
    const glm::dvec3 offset = glm::dvec3(points[i]) - mean;
    const Eigen::Vector3d vector(offset.x, offset.y, offset.z);
    spread += vector * vector.transpose();
  }
  const double size = spread.trace();
  if (!(size > 0.0))
  {
    return { 0.0f, 0.0f, 1.0f };
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread / size);
  if (!(solver.eigenvalues()[1] > flat))
  {
    return { 0.0f, 0.0f, 1.0f };
  }
  const Eigen::Vector3d normal = solver.eigenvectors().col(0);
  return glm::normalize(glm::vec3(normal.x(), normal.y(), normal.z()));
}

} // namespace ink
