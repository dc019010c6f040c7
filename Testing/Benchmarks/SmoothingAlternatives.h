// SPDX-License-Identifier: BSD-3-Clause
// Ways to smooth an iso-surface that vtkInk does not have, to compare those that it has with.
#ifndef SmoothingAlternatives_h
#define SmoothingAlternatives_h

#include "SampledVolume.h"

#include "Core/ParallelFor.h"
#include "Fields/Resampling/SmoothGrid.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

/// du/dt of a voxel's value, of its gradient and second derivatives.
template <class Rate>
void evolve(ink::testing::Volume<float>& volume, double time, const Rate& rate)
{
  constexpr double longest = 0.1; // explicit steps are stable up to 1/6
  const int steps = static_cast<int>(std::ceil(time / longest));
  const glm::ivec3 n = volume.geometry.dimensions();
  for (int step = 0; step < steps; ++step)
  {
    const ink::testing::Volume<float> before = volume;
    const auto field = before.field();
    ink::parallelFor(static_cast<std::size_t>(n.z - 2),
      [&](std::size_t slice)
      {
        for (int j = 1; j < n.y - 1; ++j)
        {
          for (int i = 1; i < n.x - 1; ++i)
          {
            const glm::ivec3 at(i, j, static_cast<int>(slice) + 1);
            volume.at(at) += static_cast<float>(time / steps * rate(field, at));
          }
        }
      });
  }
}

/// Diffusion that stops at edges (Perona and Malik, "Scale-space and edge detection using anisotropic
/// diffusion", 1990), as a scheme of the six neighbors.
/// @param edge the difference of neighbors that counts as an edge
inline void diffuseValues(ink::testing::Volume<float>& volume, double time, double edge)
{
  evolve(volume, time,
    [edge](const auto& field, const glm::ivec3& at)
    {
      double sum = 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        for (const int way : { -1, 1 })
        {
          glm::ivec3 next = at;
          next[axis] += way;
          const double d = static_cast<double>(field.at(next)) - field.at(at);
          sum += d * std::exp(-d * d / (edge * edge));
        }
      }
      return sum;
    });
}

/// Level sets that move by their curvature: the mean of both (Alvarez, Guichard, Lions and Morel, 1993), or
/// the smaller one, by which tubes keep their thickness (Lorigo et al., "CURVES", 2001).
enum class Curvature
{
  Mean,
  Smaller
};

inline void flowByCurvature(ink::testing::Volume<float>& volume, double time, Curvature kind)
{
  evolve(volume, time,
    [kind](const auto& field, const glm::ivec3& at)
    {
      const glm::dvec3 gradient = field.gradientAt(at);
      const double length = glm::length(gradient);
      if (!(length > 1e-4))
      {
        return 0.0;
      }
      // The second derivatives along the level set: two numbers and their mixed one.
      const glm::dvec3 normal = gradient / length;
      const glm::dvec3 aside = std::abs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
      const glm::dvec3 u = glm::normalize(glm::cross(normal, aside));
      const glm::dvec3 v = glm::cross(normal, u);
      const glm::dmat3 hessian = field.hessianAt(at);
      const double a = glm::dot(u, hessian * u);
      const double b = glm::dot(u, hessian * v);
      const double c = glm::dot(v, hessian * v);
      if (kind == Curvature::Mean)
      {
        return a + c;
      }
      const double middle = 0.5 * (a + c);
      const double apart = std::sqrt(0.25 * (a - c) * (a - c) + b * b);
      return middle > 0.0 ? middle - apart : middle + apart;
    });
}

/// Normals averaged along the surface, by a Gaussian of the distance and one of the angle between them, so
/// that other sides do not count (Fleishman, Drori and Cohen-Or, "Bilateral mesh denoising", 2003).
/// @param deviation voxels
template <class Real>
void smoothNormals(ink::testing::Samples<Real>& samples, double deviation)
{
  constexpr double angle = 0.6;
  const double reach = 2.0 * deviation;
  const auto keyOf = [reach](const glm::dvec3& p)
  {
    const glm::dvec3 cell = glm::floor(p / reach) + 512.0;
    return (static_cast<std::int64_t>(cell.z) * 1024 + static_cast<std::int64_t>(cell.y)) * 1024 +
      static_cast<std::int64_t>(cell.x);
  };
  std::vector<std::pair<std::int64_t, std::size_t>> order(samples.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = { keyOf(samples.point(i)), i };
  }
  std::sort(order.begin(), order.end());
  std::unordered_map<std::int64_t, std::size_t> begins;
  for (std::size_t i = order.size(); i-- > 0;)
  {
    begins[order[i].first] = i;
  }
  std::vector<float> smoothed(samples.components.size());
  ink::parallelFor(samples.size(),
    [&](std::size_t i)
    {
      const glm::dvec3 p = samples.point(i);
      const glm::dvec3 n = samples.normal(i);
      glm::dvec3 sum(0.0);
      for (int neighbor = 0; neighbor < 27; ++neighbor)
      {
        const glm::dvec3 step(neighbor % 3 - 1, neighbor / 3 % 3 - 1, neighbor / 9 - 1);
        const std::int64_t key = keyOf(p + reach * step);
        const auto begin = begins.find(key);
        for (std::size_t k = begin == begins.end() ? order.size() : begin->second;
             k < order.size() && order[k].first == key; ++k)
        {
          const glm::dvec3 d = samples.point(order[k].second) - p;
          const glm::dvec3 other = samples.normal(order[k].second);
          const double turned = std::acos(std::clamp(glm::dot(n, other), -1.0, 1.0)) / angle;
          const double distance = glm::length(d) / deviation;
          sum += std::exp(-0.5 * (distance * distance + turned * turned)) * other;
        }
      }
      const glm::dvec3 mean = glm::normalize(sum);
      for (int axis = 0; axis < 3; ++axis)
      {
        smoothed[3 * i + static_cast<std::size_t>(axis)] = static_cast<float>(mean[axis]);
      }
    });
  samples.components = std::move(smoothed);
}

/// Normals of values smoothed by a Gaussian, at samples of the values as they are.
template <class Real>
void takeSmoothedNormals(
  ink::testing::Samples<Real>& samples, const ink::GridField<float>& field, double deviation)
{
  const std::vector<float> values = ink::smoothGrid(field, glm::dvec3(deviation));
  const ink::GridField<float> smooth(field.geometry(), values);
  ink::parallelFor(samples.size(),
    [&](std::size_t i)
    {
      const glm::dvec3 normal = -glm::normalize(smooth.gradient(samples.point(i)));
      for (int axis = 0; axis < 3; ++axis)
      {
        samples.components[3 * i + static_cast<std::size_t>(axis)] = static_cast<float>(normal[axis]);
      }
    });
}

#endif
