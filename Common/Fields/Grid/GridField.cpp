// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/Grid/GridField.h"

#include "Fields/Field.h"

#include <glm/common.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace ink
{
namespace
{

glm::ivec3 step(int axis, int by = 1)
{
  glm::ivec3 s(0);
  s[axis] = by;
  return s;
}

} // namespace

template <class T>
GridField<T>::GridField(
  const GridGeometry& geometry, std::span<const T> values, std::size_t stride, const ElementMarks& hidden)
  : Geometry(geometry)
  , Values(values)
  , Stride(stride)
  , Hidden(hidden)
{
  const std::size_t count = geometry.sampleCount();
  if (stride == 0 || (count > 0 && values.size() < (count - 1) * stride + 1))
  {
    throw std::invalid_argument("the grid has more samples than values were given");
  }
  if (!hidden.empty() && hidden.bytes.size() < count)
  {
    throw std::invalid_argument("the grid has more samples than marks were given");
  }
}

template <class T>
bool GridField<T>::has(const glm::ivec3& sample) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (sample[axis] < 0 || sample[axis] >= this->Geometry.dimensions()[axis])
    {
      return false;
    }
  }
  if (!this->Hidden.empty() && this->Hidden[this->Geometry.offset(sample)])
  {
    return false;
  }
  if constexpr (std::is_floating_point_v<T>)
  {
    return std::isfinite(this->at(sample));
  }
  return true;
}

template <class T>
double GridField<T>::slopeAt(const glm::ivec3& sample, int axis) const
{
  const glm::ivec3 before = sample - step(axis);
  const glm::ivec3 after = sample + step(axis);
  const bool hasBefore = this->has(before);
  const bool hasAfter = this->has(after);
  if (hasBefore && hasAfter)
  {
    // In two halves, because the full step may overflow.
    const T middle = this->at(sample);
    const double slope =
      0.5 * difference(this->at(after), middle) + 0.5 * difference(middle, this->at(before));
    if constexpr (std::is_same_v<T, double>)
    {
      // Half steps may overflow, too.
      return std::isfinite(slope) ? slope : 0.5 * this->at(after) - 0.5 * this->at(before);
    }
    return slope;
  }
  return hasAfter ? difference(this->at(after), this->at(sample))
    : hasBefore   ? difference(this->at(sample), this->at(before))
                  : 0.0;
}

template <class T>
double GridField<T>::bendAt(const glm::ivec3& sample, int axis) const
{
  // Centered where both neighbors exist, otherwise shifted one sample inwards.
  for (const int shift : { 0, 1, -1 })
  {
    const glm::ivec3 middle = sample + step(axis, shift);
    if (this->has(middle - step(axis)) && this->has(middle) && this->has(middle + step(axis)))
    {
      const T f = this->at(middle);
      return difference(this->at(middle + step(axis)), f) - difference(f, this->at(middle - step(axis)));
    }
  }
  return 0.0;
}

template <class T>
double GridField<T>::twistAt(const glm::ivec3& sample, int axisA, int axisB) const
{
  glm::ivec3 before = sample - step(axisB);
  glm::ivec3 after = sample + step(axisB);
  before = this->has(before) ? before : sample;
  after = this->has(after) ? after : sample;
  const int steps = after[axisB] - before[axisB];
  return steps == 0 ? 0.0 : (this->slopeAt(after, axisA) - this->slopeAt(before, axisA)) / steps;
}

template <class T>
glm::dvec3 GridField<T>::gradientNearMissing(const glm::ivec3& sample) const
{
  return { this->slopeAt(sample, 0), this->slopeAt(sample, 1), this->slopeAt(sample, 2) };
}

template <class T>
glm::dmat3 GridField<T>::hessianAt(const glm::ivec3& sample) const
{
  glm::dmat3 h;
  if (this->Hidden.empty() && this->isInner(sample))
  {
    // As gradientAt: most samples have all neighbors.
    const T* const middle = this->Values.data() + this->Geometry.offset(sample) * this->Stride;
    const glm::ivec3& n = this->Geometry.dimensions();
    const auto column = static_cast<std::ptrdiff_t>(this->Stride);
    const std::ptrdiff_t steps[] = { column, column * n.x, column * n.x * n.y };
    const auto slope = [](const T* at, std::ptrdiff_t to)
    { return 0.5 * difference(at[to], *at) + 0.5 * difference(*at, at[-to]); };
    double sum = 0.0;
    for (int a = 0; a < 3; ++a)
    {
      const int b = (a + 1) % 3;
      h[a][a] = difference(middle[steps[a]], *middle) - difference(*middle, middle[-steps[a]]);
      const double twistA = (slope(middle + steps[b], steps[a]) - slope(middle - steps[b], steps[a])) / 2;
      const double twistB = (slope(middle + steps[a], steps[b]) - slope(middle - steps[a], steps[b])) / 2;
      h[a][b] = h[b][a] = 0.5 * (twistA + twistB);
      sum += h[a][a] + h[a][b];
    }
    if (std::is_integral_v<T> || sum - sum == 0.0)
    {
      return h;
    }
  }
  for (int a = 0; a < 3; ++a)
  {
    h[a][a] = this->bendAt(sample, a);
    const int b = (a + 1) % 3;
    // At a border the two orders of differentiation differ: their mean keeps the matrix symmetric.
    h[a][b] = h[b][a] = 0.5 * (this->twistAt(sample, a, b) + this->twistAt(sample, b, a));
  }
  return h;
}

template <class T>
template <class Result, class At>
Result GridField<T>::interpolate(const glm::dvec3& world, const At& at) const
{
  Result undefined(0.0);
  undefined += std::numeric_limits<double>::quiet_NaN();
  if (this->Geometry.sampleCount() == 0)
  {
    return undefined;
  }
  // Global indices, so that what pieces of one grid make of a point agrees to the last bit.
  const glm::dvec3 first(this->Geometry.first());
  const glm::dvec3 last(this->Geometry.first() + this->Geometry.dimensions() - 1);
  const glm::dvec3 index = glm::clamp(this->Geometry.toGlobalIndex(world), first, last);
  if (index != index)
  {
    return undefined;
  }
  const glm::dvec3 low = glm::floor(index);
  const glm::dvec3 fraction = index - low;
  Result sum(0.0);
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::ivec3 upper(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      weight *= upper[axis] ? fraction[axis] : 1.0 - fraction[axis];
    }
    if (weight > 0.0)
    {
      const glm::ivec3 sample = glm::ivec3(low) - this->Geometry.first() + upper;
      if (!this->has(sample))
      {
        return undefined;
      }
      sum += weight * at(sample);
    }
  }
  return sum;
}

template <class T>
double GridField<T>::value(const glm::dvec3& world) const
{
  return this->interpolate<double>(
    world, [this](const glm::ivec3& sample) { return static_cast<double>(this->at(sample)); });
}

template <class T>
glm::dvec3 GridField<T>::gradient(const glm::dvec3& world) const
{
  return this->Geometry.gradientToWorld(this->interpolate<glm::dvec3>(
    world, [this](const glm::ivec3& sample) { return this->gradientAt(sample); }));
}

template <class T>
glm::dmat3 GridField<T>::hessian(const glm::dvec3& world) const
{
  return this->Geometry.hessianToWorld(this->interpolate<glm::dmat3>(
    world, [this](const glm::ivec3& sample) { return this->hessianAt(sample); }));
}

#define INK_INSTANTIATE(T)                                                                                   \
  static_assert(Field<GridField<T>>);                                                                        \
  template class GridField<T>;
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
