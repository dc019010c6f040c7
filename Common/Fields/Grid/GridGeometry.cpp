// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/Grid/GridGeometry.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ink
{
namespace
{

bool allFinite(const glm::dvec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

glm::dmat3 diagonal(const glm::dvec3& d)
{
  return { { d.x, 0, 0 }, { 0, d.y, 0 }, { 0, 0, d.z } };
}

} // namespace

GridGeometry::GridGeometry(const glm::ivec3& dimensions, const glm::dvec3& origin, const glm::dvec3& spacing,
  const glm::dmat3& direction, const glm::ivec3& first)
  : Dimensions(dimensions)
  , First(first)
  , Origin(origin)
  , Spacing(spacing)
  , Direction(direction)
{
  if (glm::any(glm::lessThan(dimensions, glm::ivec3(0))))
  {
    throw std::invalid_argument("the grid's dimensions must not be negative");
  }
  if (!allFinite(origin))
  {
    throw std::invalid_argument("the grid's origin must be finite");
  }
  if (!allFinite(spacing) || glm::any(glm::equal(spacing, glm::dvec3(0.0))))
  {
    throw std::invalid_argument("the grid's spacing must be finite and not zero");
  }
  this->InverseDirection = glm::inverse(direction);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!allFinite(direction[axis]) || !allFinite(this->InverseDirection[axis]))
    {
      throw std::invalid_argument("the grid's direction matrix must be invertible");
    }
  }
  this->StepToWorld = direction * diagonal(spacing);

  const glm::dvec3 size = glm::abs(spacing);
  const double smallest = std::min({ size.x, size.y, size.z });
  this->GradientDirection = glm::transpose(this->InverseDirection) * diagonal(smallest / spacing);
}

std::size_t GridGeometry::sampleCount() const
{
  return static_cast<std::size_t>(this->Dimensions.x) * this->Dimensions.y * this->Dimensions.z;
}

double GridGeometry::smallestSpacing() const
{
  const glm::dmat3& steps = this->StepToWorld;
  return std::min({ glm::length(steps[0]), glm::length(steps[1]), glm::length(steps[2]) });
}

glm::dvec3 GridGeometry::toWorld(const glm::dvec3& index) const
{
  return this->Origin + this->StepToWorld * (glm::dvec3(this->First) + index);
}

glm::dvec3 GridGeometry::toIndex(const glm::dvec3& world) const
{
  return this->toGlobalIndex(world) - glm::dvec3(this->First);
}

bool GridGeometry::contains(const glm::dvec3& world) const
{
  const glm::dvec3 index = this->toIndex(world);
  return glm::all(glm::greaterThanEqual(index, glm::dvec3(0.0))) &&
    glm::all(glm::lessThanEqual(index, glm::dvec3(this->Dimensions - 1)));
}

glm::dvec3 GridGeometry::toGlobalIndex(const glm::dvec3& world) const
{
  return (this->InverseDirection * (world - this->Origin)) / this->Spacing;
}

glm::dvec3 GridGeometry::gradientToWorld(const glm::dvec3& perSample) const
{
  return glm::transpose(this->InverseDirection) * (perSample / this->Spacing);
}

glm::dmat3 GridGeometry::hessianToWorld(const glm::dmat3& perSample) const
{
  glm::dmat3 scaled;
  for (int axis = 0; axis < 3; ++axis)
  {
    scaled[axis] = perSample[axis] / this->Spacing[axis] / this->Spacing;
  }
  return glm::transpose(this->InverseDirection) * scaled * this->InverseDirection;
}

} // namespace ink
