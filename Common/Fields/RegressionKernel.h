#pragma once

#include "Fields/GridGeometry.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// How much a neighbor counts in the regression.
enum class RegressionWeighting
{
  /// Every neighbor the same: the least noise.
  Uniform,
  /// The reciprocal of the neighbor's distance in world units, the center as much as the nearest neighbor.
  InverseDistance
};

/// The neighbors of a sample within `radius` steps along each axis, itself included: offsets with x running
/// fastest, from (-radius, -radius, -radius).
std::vector<glm::ivec3> neighborhood(int radius);

/// The weight of each neighbor, in the order of neighborhood(radius), the nearest one's 1. Neumann et al.
/// (2000) ask for weights that fall with the distance and leave the function open; implementations take the
/// reciprocal Euclidean distance.
std::vector<double> regressionWeights(
  const GridGeometry& geometry, int radius, RegressionWeighting weighting);

/// The plane value + gradient . offset that fits the samples at some offsets best, in the sense of weighted
/// least squares: the 4D linear regression of Neumann et al. (2000), with their sums written for neighbors
/// that need not lie around the center evenly. With the samples f and the weights w:
///   gradient = inverse * sum w (offset - mean) f    per sample step
///   value    = sum w f / total - gradient . mean
/// Along directions that the offsets do not determine, as across a single slice, the gradient is 0.
struct PlaneFit
{
  /// Of the weights.
  double total = 0.0;
  /// Of the offsets, weighted.
  glm::dvec3 mean = glm::dvec3(0.0);
  /// Of sum w (offset - mean)(offset - mean)^T.
  glm::dmat3 inverse = glm::dmat3(0.0);

  /// \param offsets, weights one each for every neighbor
  /// \param used which of them there are, not 0 for those; all when empty
  PlaneFit(std::span<const glm::ivec3> offsets, std::span<const double> weights,
    std::span<const std::uint8_t> used = {});
};

/// The same as one coefficient for each sample, which gradient and value are the sums of:
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
