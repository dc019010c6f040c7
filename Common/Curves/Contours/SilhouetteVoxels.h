// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Curves/Contours/Contours.h"
#include "Curves/Contours/Eye.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace ink
{

template <class T>
class GridField;

/// The silhouette curves of volumes of Lu et al. (2003, section 5.6): a short segment through the center of
/// each voxel that lies on an edge in the volume and whose gradient is about perpendicular to the direction
/// to the eye. Segments are not joined; exact and connected curves are those of GridContours, for an
/// iso-value.

/// Voxels that lie on an edge, whatever the eye. Arrays have one entry a voxel, in grid order.
struct EdgeVoxels
{
  std::vector<std::size_t> samples; ///< the voxel's sample, by its index in the grid
  std::vector<glm::dvec3> positions;
  std::vector<glm::vec3> gradients; ///< central differences, in value per world unit
  std::vector<float> values;
};

/// Finds edge voxels by zero crossings of the Laplacian of Gaussian: those where it has another sign than at
/// one of the six neighbors and is no farther from zero than there. A voxel without a gradient is none.
/// @param deviation of the Gaussian along each axis in samples, from 0 to largestGaussian
/// @param leastMagnitude of the gradient, in value per world unit: voxels with less are left out, of which a
///   volume with noise has many
/// @param progress when it asks to stop, no voxels are found
/// @throws std::invalid_argument when a deviation is out of range
template <class T>
EdgeVoxels findEdgeVoxels(const GridField<T>& field, const glm::dvec3& deviation, double leastMagnitude = 0.0,
  const Progress& progress = {});

/// Which edge voxels get a segment, for one eye: "a criteria based on the scalar data value, the gradient
/// magnitude, the gradient direction, the eye vector, and several user defined parameters". The paper does
/// not print it; these thresholds are what it names.
struct SilhouetteCriteria
{
  float lowest = -std::numeric_limits<float>::infinity(); ///< value
  float highest = std::numeric_limits<float>::infinity(); ///< value
  float leastMagnitude = 0.0f;                            ///< of the gradient, in value per world unit
  float largestCosine = 0.1f; ///< of the angle between gradient and direction to the eye, regardless of sign

  /// @param gradient, toEye of any length other than 0
  bool accept(float value, const glm::vec3& gradient, const glm::vec3& toEye) const;
};

/// The voxels that pass for an eye, ascending, by their index in EdgeVoxels. The same for any number of
/// threads.
std::vector<std::uint32_t> selectSilhouetteVoxels(
  const EdgeVoxels& voxels, const SilhouetteCriteria& criteria, const Eye& eye);

/// The ends of a segment through the center of a voxel, in the direction gradient x eye. Both are the center
/// where these are parallel.
std::array<glm::dvec3, 2> silhouetteSegment(
  const glm::dvec3& center, const glm::vec3& gradient, const glm::dvec3& toEye, double length);

/// The segments through some voxels as contours of two points each, in the voxels' order. Normals point along
/// the negative gradient; elements are the voxels' samples; the radial curvature, which nothing here tells,
/// is 0.
/// @param selected indices of `voxels`
Contours silhouetteSegments(const EdgeVoxels& voxels, std::span<const std::uint32_t> selected, const Eye& eye,
  double length, const ContourArrays& arrays);

/// The exhaustive search that the edge voxels replace, for reference: for one eye, the voxels within the
/// bounds of value and gradient magnitude that
/// - lie on an edge: of the 26 neighbors, the two closest to the line along the gradient have no greater
///   gradient magnitude, and
/// - on a silhouette: of these neighbors with enough gradient and the voxel itself, some are turned to the
///   eye and others away from it.
/// `largestCosine` is of no effect.
/// @return indices of samples, ascending
template <class T>
std::vector<std::size_t> searchSilhouetteVoxels(
  const GridField<T>& field, const SilhouetteCriteria& criteria, const Eye& eye);

/// Position, gradient and value of voxels.
/// @param samples indices in the grid
template <class T>
EdgeVoxels describeVoxels(const GridField<T>& field, std::span<const std::size_t> samples);

} // namespace ink
