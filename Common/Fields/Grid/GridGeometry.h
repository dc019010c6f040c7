// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstddef>

namespace ink
{

/// The positions of the samples of a regular grid. Sample (i, j, k), counted from the grid's own first
/// sample, has the global index `first + (i, j, k)` and lies at `origin + direction * (spacing * global
/// index)`.
///
/// World points are in world units; indices are in samples, relative to the grid's own first sample. Spacing
/// may be negative and `direction` may be any invertible matrix: mirrored, sheared or scaled.
class GridGeometry
{
public:
  /// @param dimensions samples along each axis
  /// @param origin the position of global index (0, 0, 0)
  /// @param spacing world units between samples
  /// @param direction its columns are the world directions of the three axes
  /// @param first the global index of the first sample
  /// @throws std::invalid_argument when a dimension is negative, a number is not finite, a spacing is zero or
  ///   the direction matrix is singular
  GridGeometry(const glm::ivec3& dimensions, const glm::dvec3& origin = glm::dvec3(0.0),
    const glm::dvec3& spacing = glm::dvec3(1.0), const glm::dmat3& direction = glm::dmat3(1.0),
    const glm::ivec3& first = glm::ivec3(0));

  const glm::ivec3& dimensions() const { return this->Dimensions; }
  /// The global index of the grid's own first sample.
  const glm::ivec3& first() const { return this->First; }
  const glm::dvec3& origin() const { return this->Origin; }
  const glm::dvec3& spacing() const { return this->Spacing; }
  const glm::dmat3& direction() const { return this->Direction; }
  std::size_t sampleCount() const;
  /// The least distance of samples along an axis, in world units.
  double smallestSpacing() const;

  /// The index of sample (i, j, k) in an array of the samples, i fastest.
  std::size_t offset(const glm::ivec3& sample) const
  {
    return sample.x +
      static_cast<std::size_t>(this->Dimensions.x) *
      (sample.y + static_cast<std::size_t>(this->Dimensions.y) * sample.z);
  }

  /// Computed from global indices, so that pieces of one grid agree bitwise.
  glm::dvec3 toWorld(const glm::dvec3& index) const;
  glm::dvec3 toIndex(const glm::dvec3& world) const;
  /// Whether it lies between the grid's own samples; false for NaN and infinity.
  bool contains(const glm::dvec3& world) const;
  /// Not counted from the grid's own first sample, so that pieces of one grid agree to the last bit.
  glm::dvec3 toGlobalIndex(const glm::dvec3& world) const;

  /// First derivatives per sample step to first derivatives per world unit.
  glm::dvec3 gradientToWorld(const glm::dvec3& perSample) const;
  /// Second derivatives per sample step to second derivatives per world unit.
  glm::dmat3 hessianToWorld(const glm::dmat3& perSample) const;

  /// Maps a gradient per sample step to a vector along the world gradient. Scaled so that the axis with the
  /// smallest spacing keeps its length: neither very small nor very large spacings overflow.
  const glm::dmat3& gradientDirection() const { return this->GradientDirection; }
  /// Maps index steps to world steps.
  const glm::dmat3& stepToWorld() const { return this->StepToWorld; }

private:
  glm::ivec3 Dimensions;
  glm::ivec3 First;
  glm::dvec3 Origin;
  glm::dvec3 Spacing;
  glm::dmat3 Direction;
  glm::dmat3 StepToWorld;
  glm::dmat3 InverseDirection;
  glm::dmat3 GradientDirection;
};

} // namespace ink
