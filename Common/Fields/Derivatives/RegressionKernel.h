// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

class GridGeometry;

/// The weights of neighbors in the regression.
enum class RegressionWeighting
{
  /// Equal weights: the least noise.
  Uniform,
  /// The reciprocal of the neighbor's distance in world units; the center has the weight of the nearest
  /// neighbor.
  InverseDistance
};

/// The neighbors of a sample within `radius` steps along each axis, including itself: offsets, x fastest,
/// from (-radius, -radius, -radius).
std::vector<glm::ivec3> neighborhood(int radius);

/// The weight of each neighbor, in the order of neighborhood(radius); the nearest one's is 1. Neumann et al.
/// (2000) require weights that fall with the distance but leave the function open; implementations use the
/// reciprocal Euclidean distance.
std::vector<double> regressionWeights(
  const GridGeometry& geometry, int radius, RegressionWeighting weighting);

/// The hyperplane value + gradient . offset fitted to samples by weighted least squares: the 4D linear
/// regression of Neumann et al. (2000), generalized to neighborhoods that are not symmetric about the center.
/// With samples f and weights w:
///   gradient = inverse * sum w (offset - mean) f    per sample step
///   value    = sum w f / total - gradient . mean
/// Along directions that the offsets do not determine, such as across a single slice, the gradient is 0.
struct PlaneFit
{
  /// Sum of the weights.
  double total = 0.0;
  /// Weighted mean of the offsets.
  glm::dvec3 mean = glm::dvec3(0.0);
  /// Pseudoinverse of sum w (offset - mean)(offset - mean)^T.
  glm::dmat3 inverse = glm::dmat3(0.0);

  /// @param offsets, weights one per neighbor
  /// @param used nonzero for neighbors that exist; empty: all
  PlaneFit(std::span<const glm::ivec3> offsets, std::span<const double> weights,
    std::span<const std::uint8_t> used = {});
};

/// The same as one coefficient per sample:
///   gradient = sum gradient[n] * sample[n]     per sample step
///   value    = sum value[n] * sample[n]
struct RegressionKernel
{
  std::vector<glm::dvec3> gradient;
  std::vector<double> value;

  RegressionKernel(std::span<const glm::ivec3> offsets, std::span<const double> weights,
    std::span<const std::uint8_t> used = {});
};

} // namespace ink
