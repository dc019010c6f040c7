// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/Derivatives/RegressionKernel.h"

#include "Fields/Grid/GridGeometry.h"

#include <Eigen/Eigenvalues>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ink
{
namespace
{

/// A direction with a smaller fraction of the neighbors' variance counts as undetermined.
constexpr double rankTolerance = 1e-9;

/// The pseudoinverse of a symmetric matrix. The matrix is first scaled to a unit diagonal, so that weights of
/// very different magnitudes do not hide an axis.
glm::dmat3 pseudoInverse(const glm::dmat3& symmetric)
{
  glm::dvec3 scale(0.0);
  Eigen::Matrix3d scaled;
  for (int axis = 0; axis < 3; ++axis)
  {
    scale[axis] = symmetric[axis][axis] > 0.0 ? 1.0 / std::sqrt(symmetric[axis][axis]) : 0.0;
  }
  for (int a = 0; a < 3; ++a)
  {
    for (int b = 0; b < 3; ++b)
    {
      scaled(a, b) = symmetric[a][b] * scale[a] * scale[b];
    }
  }
  Eigen::Matrix3d inverse;
  if (scaled.isDiagonal(0.0))
  {
    inverse = scaled;
  }
  else
  {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scaled);
    Eigen::Vector3d reciprocal = solver.eigenvalues();
    for (int n = 0; n < 3; ++n)
    {
      reciprocal[n] = reciprocal[n] > rankTolerance ? 1.0 / reciprocal[n] : 0.0;
    }
    inverse = solver.eigenvectors() * reciprocal.asDiagonal() * solver.eigenvectors().transpose();
  }
  glm::dmat3 result;
  for (int a = 0; a < 3; ++a)
  {
    for (int b = 0; b < 3; ++b)
    {
      result[a][b] = inverse(a, b) * scale[a] * scale[b];
    }
  }
  return result;
}

} // namespace

std::vector<glm::ivec3> neighborhood(int radius)
{
  std::vector<glm::ivec3> offsets;
  for (int c = -radius; c <= radius; ++c)
  {
    for (int b = -radius; b <= radius; ++b)
    {
      for (int a = -radius; a <= radius; ++a)
      {
        offsets.emplace_back(a, b, c);
      }
    }
  }
  return offsets;
}

std::vector<double> regressionWeights(const GridGeometry& geometry, int radius, RegressionWeighting weighting)
{
  const std::vector<glm::ivec3> offsets = neighborhood(radius);
  std::vector<double> weights(offsets.size(), 1.0);
  if (weighting == RegressionWeighting::InverseDistance)
  {
    // Relative to the longest step, so that tiny and huge spacings stay in the range of double.
    const glm::dmat3& toWorld = geometry.stepToWorld();
    double longest = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int component = 0; component < 3; ++component)
      {
        longest = std::max(longest, std::abs(toWorld[axis][component]));
      }
    }
    std::vector<double> distances;
    double nearest = std::numeric_limits<double>::infinity();
    for (const glm::ivec3& offset : offsets)
    {
      distances.push_back(glm::length(toWorld / longest * glm::dvec3(offset)));
      nearest = distances.back() > 0.0 ? std::min(nearest, distances.back()) : nearest;
    }
    for (std::size_t n = 0; n < weights.size(); ++n)
    {
      weights[n] = nearest / std::max(nearest, distances[n]);
    }
  }
  return weights;
}

PlaneFit::PlaneFit(
  std::span<const glm::ivec3> offsets, std::span<const double> weights, std::span<const std::uint8_t> used)
{
  for (std::size_t n = 0; n < offsets.size(); ++n)
  {
    if (used.empty() || used[n])
    {
      this->total += weights[n];
      this->mean += weights[n] * glm::dvec3(offsets[n]);
    }
  }
  if (this->total <= 0.0)
  {
    return;
  }
  this->mean /= this->total;
  glm::dmat3 spread(0.0);
  for (std::size_t n = 0; n < offsets.size(); ++n)
  {
    if (used.empty() || used[n])
    {
      const glm::dvec3 d = glm::dvec3(offsets[n]) - this->mean;
      spread += weights[n] * glm::outerProduct(d, d);
    }
  }
  this->inverse = pseudoInverse(spread);
}

RegressionKernel::RegressionKernel(
  std::span<const glm::ivec3> offsets, std::span<const double> weights, std::span<const std::uint8_t> used)
  : gradient(offsets.size(), glm::dvec3(0.0))
  , value(offsets.size(), 0.0)
{
  const PlaneFit fit(offsets, weights, used);
  for (std::size_t n = 0; n < offsets.size(); ++n)
  {
    if (used.empty() || used[n])
    {
      this->gradient[n] = weights[n] * (fit.inverse * (glm::dvec3(offsets[n]) - fit.mean));
      this->value[n] = weights[n] / fit.total - glm::dot(this->gradient[n], fit.mean);
    }
  }
}

} // namespace ink
