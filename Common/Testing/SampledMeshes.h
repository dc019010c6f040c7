// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mesh/TriangleMesh.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace ink::test
{

/// A mesh that owns its arrays.
struct Mesh
{
  std::vector<glm::dvec3> points;
  std::vector<Triangle> triangles;
  std::vector<float> pointDensity;
  std::vector<float> triangleDensity;

  TriangleMesh view() const
  {
    return { this->points, this->triangles, this->pointDensity, this->triangleDensity };
  }

  /// Adds a grid of columns x rows quads, cut in two, at position(u, v) with u and v from 0 to 1.
  void addPatch(int columns, int rows, const std::function<glm::dvec3(double, double)>& position)
  {
    const auto first = static_cast<std::uint32_t>(this->points.size());
    for (int row = 0; row <= rows; ++row)
    {
      for (int column = 0; column <= columns; ++column)
      {
        this->points.push_back(position(double(column) / columns, double(row) / rows));
      }
    }
    const auto stride = static_cast<std::uint32_t>(columns + 1);
    for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(rows); ++row)
    {
      for (std::uint32_t column = 0; column + 1 < stride; ++column)
      {
        const std::uint32_t corner = first + row * stride + column;
        this->triangles.push_back({ corner, corner + 1, corner + stride + 1 });
        this->triangles.push_back({ corner, corner + stride + 1, corner + stride });
      }
    }
  }
};

/// Each triangle with points of its own, as some files have them.
inline Mesh soupOf(const Mesh& mesh)
{
  Mesh soup;
  for (const Triangle& triangle : mesh.triangles)
  {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (const std::uint32_t point : triangle)
    {
      soup.points.push_back(mesh.points[point]);
    }
    soup.triangles.push_back({ first, first + 1, first + 2 });
  }
  return soup;
}

/// The unit square at a height, facing up.
inline Mesh square(int cells, double height = 0.0)
{
  Mesh mesh;
  mesh.addPatch(cells, cells, [=](double u, double v) { return glm::dvec3(u, v, height); });
  return mesh;
}

/// A unit sphere of longitudes and latitudes; the triangles at the poles have no area, the seam is open but
/// for the positions.
inline Mesh sphere(int columns, int rows)
{
  Mesh mesh;
  mesh.addPatch(columns, rows,
    [=](double u, double v)
    {
      const double around = u == 1.0 ? 0.0 : 2.0 * std::numbers::pi * u;
      const double down = std::numbers::pi * v;
      const double width = v == 0.0 || v == 1.0 ? 0.0 : std::sin(down);
      return glm::dvec3(width * std::cos(around), width * std::sin(around), -std::cos(down));
    });
  return mesh;
}

inline Mesh torus(double radius, double tube, int columns, int rows)
{
  Mesh mesh;
  mesh.addPatch(columns, rows,
    [=](double u, double v)
    {
      const double around = u == 1.0 ? 0.0 : 2.0 * std::numbers::pi * u;
      const double across = v == 1.0 ? 0.0 : 2.0 * std::numbers::pi * v;
      const double out = radius + tube * std::cos(across);
      return glm::dvec3(out * std::cos(around), out * std::sin(around), tube * std::sin(across));
    });
  return mesh;
}

inline std::vector<glm::dvec3> positionsOf(const TriangleMesh& mesh, std::span<const SurfaceSample> samples)
{
  std::vector<glm::dvec3> positions;
  for (const SurfaceSample& sample : samples)
  {
    positions.push_back(positionOf(mesh, sample));
  }
  return positions;
}

/// Slow and obvious: the least distance between two of the first `count` points.
inline double leastDistance(std::span<const glm::dvec3> points, std::size_t count)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const glm::dvec3 offset = points[i] - points[j];
      least = std::min(least, glm::dot(offset, offset));
    }
  }
  return std::sqrt(least);
}

/// Brute force: the largest distance from one of the positions to the nearest of the first `count` points.
inline double largestGap(
  std::span<const glm::dvec3> probes, std::span<const glm::dvec3> points, std::size_t count)
{
  double largest = 0.0;
  for (const glm::dvec3& probe : probes)
  {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count; ++i)
    {
      const glm::dvec3 offset = points[i] - probe;
      least = std::min(least, glm::dot(offset, offset));
    }
    largest = std::max(largest, least);
  }
  return std::sqrt(largest);
}

/// Runs something on a number of threads.
template <class Run>
auto onThreads(int threads, const Run& run)
{
  setenv("VTK_SMP_MAX_THREADS", std::to_string(threads).c_str(), 1);
  auto result = run();
  unsetenv("VTK_SMP_MAX_THREADS");
  return result;
}

} // namespace ink::test
