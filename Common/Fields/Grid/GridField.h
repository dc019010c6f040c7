// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Grid/ElementMarks.h"
#include "Fields/Grid/GridGeometry.h"
#include "Fields/ScalarDifference.h"

#include <cstddef>
#include <span>
#include <type_traits>

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
  glm::dvec3 gradientAt(const glm::ivec3& sample) const
  {
    if (this->Hidden.empty() && this->isInner(sample))
    {
      const glm::dvec3 gradient =
        this->gradientOfInner(this->Values.data() + this->Geometry.offset(sample) * this->Stride);
      if (isComplete(gradient))
      {
        return gradient;
      }
    }
    return this->gradientNearMissing(sample);
  }
  /// The same, by the address of the value of a sample that has neighbors on all sides, none of them hidden;
  /// what is not complete needs gradientAt.
  glm::dvec3 gradientOfInner(const T* middle) const
  {
    // Most samples: all neighbors are there and need not be looked up one by one.
    const glm::ivec3& n = this->Geometry.dimensions();
    const auto slope = [middle](std::ptrdiff_t step)
    { return 0.5 * difference(middle[step], *middle) + 0.5 * difference(*middle, middle[-step]); };
    const auto column = static_cast<std::ptrdiff_t>(this->Stride);
    return { slope(column), slope(column * n.x), slope(column * n.x * n.y) };
  }
  /// Neighbors that are floating-point numbers may be missing, and differences of doubles overflow.
  static bool isComplete(const glm::dvec3& gradient)
  {
    return std::is_integral_v<T> || gradient - gradient == glm::dvec3(0.0);
  }
  /// Second derivatives at a sample, per sample step.
  glm::dmat3 hessianAt(const glm::ivec3& sample) const;

  double value(const glm::dvec3& world) const;
  glm::dvec3 gradient(const glm::dvec3& world) const;
  glm::dmat3 hessian(const glm::dvec3& world) const;

  /// Whether it has neighbors on all sides.
  bool isInner(const glm::ivec3& sample) const
  {
    const glm::ivec3& n = this->Geometry.dimensions();
    return sample.x > 0 && sample.x < n.x - 1 && sample.y > 0 && sample.y < n.y - 1 && sample.z > 0 &&
      sample.z < n.z - 1;
  }

private:
  glm::dvec3 gradientNearMissing(const glm::ivec3& sample) const;
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
