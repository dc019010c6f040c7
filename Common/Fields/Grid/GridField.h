// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Grid/ElementMarks.h"
#include "Fields/Grid/GridGeometry.h"

#include <cstddef>
#include <span>

namespace ink
{

/// The field defined by samples on a regular grid: trilinear interpolation of their values, of their
/// central-difference gradients and of their second differences. Satisfies ink::Field.
///
/// A sample that is hidden, NaN or infinite is missing. Differences are one-sided at the grid's border and
/// next to a missing sample, and zero where both neighbors are missing. Points outside the grid are clamped
/// to it; where an interpolated sample is missing, the result is NaN.
///
/// A view: it does not own the samples. T is one of INK_FOR_EACH_SCALAR.
template <class T>
class GridField
{
public:
  /// @param values samples, i fastest; sample n is values[n * stride]
  /// @param stride the distance between samples, that is the number of interleaved components
  /// @param hidden samples to treat as missing, one byte per sample
  /// @throws std::invalid_argument when the spans are too short for the grid
  GridField(const GridGeometry& geometry, std::span<const T> values, std::size_t stride = 1,
    const ElementMarks& hidden = {});

  const GridGeometry& geometry() const { return this->Geometry; }
  const T* data() const { return this->Values.data(); }
  std::size_t stride() const { return this->Stride; }
  const ElementMarks& hidden() const { return this->Hidden; }

  /// Whether the sample lies on the grid and is not missing.
  bool has(const glm::ivec3& sample) const;
  T at(const glm::ivec3& sample) const { return this->Values[this->Geometry.offset(sample) * this->Stride]; }
  /// First derivatives at a sample, per sample step.
  glm::dvec3 gradientAt(const glm::ivec3& sample) const;
  /// Second derivatives at a sample, per sample step.
  glm::dmat3 hessianAt(const glm::ivec3& sample) const;

  double value(const glm::dvec3& world) const;
  glm::dvec3 gradient(const glm::dvec3& world) const;
  glm::dmat3 hessian(const glm::dvec3& world) const;

private:
  double slopeAt(const glm::ivec3& sample, int axis) const;
  double bendAt(const glm::ivec3& sample, int axis) const;
  double twistAt(const glm::ivec3& sample, int axisA, int axisB) const;
  template <class Result, class At>
  Result interpolate(const glm::dvec3& world, const At& at) const;

  GridGeometry Geometry;
  std::span<const T> Values;
  std::size_t Stride;
  ElementMarks Hidden;
};

} // namespace ink
