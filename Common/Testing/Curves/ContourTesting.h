// SPDX-License-Identifier: BSD-3-Clause
// What the tests of contours of volumes and fields share.
#pragma once

#include "AnalyticFields.h"
#include "HashNoise.h"
#include "SampledVolume.h"

#include "Curves/Contours/Contours.h"
#include "Curves/Contours/Eye.h"
#include "Curves/Contours/GridContours.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace ink::testing
{

// What tests say often.
using ink::Contours;
using ink::Eye;
using ink::GridContourOptions;
using ink::GridContours;
using ink::GridGeometry;

inline const double pi = std::acos(-1.0);
inline const ContourArrays all{ true, true, true, true };

inline glm::dvec3 randomDirection(std::uint64_t seed)
{
  return glm::normalize(glm::dvec3(hashNormal(seed, 0), hashNormal(seed, 1), hashNormal(seed, 2)));
}

/// Dense inside.
template <class T, class Shape>
Volume<T> sampled(const GridGeometry& grid, const Shape& shape, double scale = 1.0, double inside = 0.0)
{
  return Volume<T>::from(grid, [&](const glm::dvec3& p) { return inside - scale * shape.distance(p); });
}

inline GridGeometry cube(int samples, double width)
{
  return GridGeometry(
    glm::ivec3(samples), glm::dvec3(-0.5 * width), glm::dvec3(width / static_cast<double>(samples - 1)));
}

inline void expectSame(const Contours& a, const Contours& b)
{
  EXPECT_EQ(a.chains.offsets, b.chains.offsets);
  EXPECT_EQ(a.chains.closed, b.chains.closed);
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.normals, b.normals);
  EXPECT_EQ(a.radialCurvature, b.radialCurvature);
  EXPECT_EQ(a.arcLength, b.arcLength);
  EXPECT_EQ(a.elements, b.elements);
}

/// The circle in which an eye sees a sphere.
struct Circle
{
  glm::dvec3 center;
  glm::dvec3 axis;
  double radius;

  static Circle of(const Sphere& sphere, const Eye& eye)
  {
    const glm::dvec3 view = eye.from(sphere.center);
    if (eye.parallel)
    {
      return { sphere.center, glm::normalize(view), sphere.radius };
    }
    const double share = sphere.radius / glm::length(view);
    return { sphere.center + share * share * view, glm::normalize(view),
      sphere.radius * std::sqrt(1.0 - share * share) };
  }
  double distance(const glm::dvec3& p) const
  {
    const double along = glm::dot(p - this->center, this->axis);
    return std::hypot(along, glm::length(p - this->center - along * this->axis) - this->radius);
  }
};

inline double greatestDistance(const Circle& circle, const Contours& contours)
{
  double greatest = 0.0;
  for (const glm::dvec3& p : contours.positions)
  {
    greatest = std::max(greatest, circle.distance(p));
  }
  return greatest;
}

inline const Sphere Ball{ { 0.03, -0.02, 0.05 }, 1.0 };
inline const std::array<Eye, 3> BallEyes{ Eye::at({ 3.0, 4.0, 5.0 }), Eye::at({ -1.5, 0.2, 0.1 }),
  Eye::along({ 1.0, 2.0, -20.0 }) };

/// Seen from outside with the normal upwards, what faces the eye is on the left.
inline void expectFrontOnTheLeft(const Contours& contours, const Eye& eye)
{
  ASSERT_GT(contours.positions.size(), 10u);
  double left = 0.0;
  double length = 0.0;
  for (std::size_t chain = 0; chain < contours.chains.size(); ++chain)
  {
    for (std::size_t n = contours.chains.offsets[chain]; n + 1 < contours.chains.offsets[chain + 1]; ++n)
    {
      const glm::dvec3 along = contours.positions[n + 1] - contours.positions[n];
      const glm::dvec3 view = glm::normalize(eye.from(contours.positions[n]));
      left += glm::dot(glm::cross(glm::dvec3(contours.normals[n]), along), view);
      length += glm::length(along);
    }
  }
  EXPECT_GT(left, 0.9 * length);
}

} // namespace ink::testing
