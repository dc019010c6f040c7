// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Grid/GridField.h"
#include "IsoSurface/ActiveCells.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

/// An implementation of Zhang et al. 2014, section 5.1, that is as plain as it can be: every cell, every
/// edge, one after the other. In long double, which holds all scalars exactly and their differences without
/// overflow.
namespace ink::testing
{

struct ReferenceSample
{
  glm::dvec3 index;     ///< in samples, counted from the grid's first
  glm::dvec3 direction; ///< against the normal; of no use where it is about zero
  /// How much `direction` may differ when the differences between samples are rounded to float.
  double directionError;
};

inline bool crosses(long double f1, long double f2, long double f0, CrossingRule rule)
{
  if (rule == CrossingRule::HalfOpen)
  {
    return (f1 < f0) != (f2 < f0);
  }
  return (f1 < f0 && f2 > f0) || (f1 > f0 && f2 < f0) || (f1 == f0 && f2 == f0);
}

/// The central difference along an axis, per sample; one-sided where a neighbor is missing.
template <class T>
long double slope(const GridField<T>& field, const glm::ivec3& sample, int axis)
{
  glm::ivec3 before = sample;
  glm::ivec3 after = sample;
  before[axis] -= 1;
  after[axis] += 1;
  before = field.has(before) ? before : sample;
  after = field.has(after) ? after : sample;
  const int steps = after[axis] - before[axis];
  return steps == 0
    ? 0.0L
    : (static_cast<long double>(field.at(after)) - static_cast<long double>(field.at(before))) / steps;
}

/// The trilinear interpolation of the corners' unit gradients at the point t of a unit cell.
template <class T>
ReferenceSample interpolate(
  const GridField<T>& field, const glm::ivec3& cell, const glm::dvec3& t, long double f0)
{
  ReferenceSample sample{ glm::dvec3(cell) + t, glm::dvec3(0.0), 0.0 };
  for (int c = 0; c < 8; ++c)
  {
    const glm::ivec3 upper(c & 1, c >> 1 & 1, c >> 2);
    const glm::dvec3 weights = glm::mix(1.0 - t, t, glm::dvec3(upper));
    const double weight = weights.x * weights.y * weights.z;
    const long double slopes[3] = { slope(field, cell + upper, 0), slope(field, cell + upper, 1),
      slope(field, cell + upper, 2) };
    const long double largest = std::max({ std::abs(slopes[0]), std::abs(slopes[1]), std::abs(slopes[2]) });
    if (largest == 0.0L)
    {
      continue;
    }
    // Scaled so that it fits into a double.
    const glm::dvec3 gradient = field.geometry().gradientToWorld({ static_cast<double>(slopes[0] / largest),
      static_cast<double>(slopes[1] / largest), static_cast<double>(slopes[2] / largest) });
    const double steepness = glm::length(gradient);
    sample.direction += weight / steepness * gradient;

    long double value = 0.0L;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const int step : { -1, 0, 1 })
      {
        glm::ivec3 at = cell + upper;
        at[axis] += step;
        value =
          field.has(at) ? std::max(value, std::abs(static_cast<long double>(field.at(at)) - f0)) : value;
      }
    }
    const double rounding = static_cast<double>(value / largest) * 0x1p-22;
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::dvec3 unit(0.0);
      unit[axis] = rounding;
      sample.directionError += weight * glm::length(field.geometry().gradientToWorld(unit)) / steepness;
    }
  }
  return sample;
}

/// The samples of the cells that are not marked.
template <class T>
std::vector<ReferenceSample> referenceSamples(
  const GridField<T>& field, double isoValue, CrossingRule rule, const ElementMarks& skipped = {})
{
  std::vector<ReferenceSample> samples;
  const long double f0 = isoValue;
  const glm::ivec3 cells = field.geometry().dimensions() - 1;
  std::size_t number = 0;
  for (int k = 0; k < cells.z; ++k)
  {
    for (int j = 0; j < cells.y; ++j)
    {
      for (int i = 0; i < cells.x; ++i, ++number)
      {
        const glm::ivec3 cell(i, j, k);
        glm::dvec3 sum(0.0);
        int count = 0;
        bool complete = skipped.empty() || !skipped[number];
        for (int c = 0; c < 8; ++c)
        {
          const glm::ivec3 corner = cell + glm::ivec3(c & 1, c >> 1 & 1, c >> 2);
          complete = complete && field.has(corner);
          for (int axis = 0; axis < 3; ++axis)
          {
            if (c >> axis & 1)
            {
              continue;
            }
            glm::ivec3 other = corner;
            other[axis] += 1;
            const auto f1 = static_cast<long double>(field.at(corner));
            const auto f2 = static_cast<long double>(field.at(other));
            if (crosses(f1, f2, f0, rule))
            {
              const auto alpha = static_cast<double>(f1 == f2 ? 0.5L : (f1 - f0) / (f1 - f2));
              sum += (1.0 - alpha) * glm::dvec3(corner - cell) + alpha * glm::dvec3(other - cell);
              ++count;
            }
          }
        }
        if (complete && count > 0)
        {
          samples.push_back(interpolate(field, cell, sum / static_cast<double>(count), f0));
        }
      }
    }
  }
  return samples;
}

} // namespace ink::testing
