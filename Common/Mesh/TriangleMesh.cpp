// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/TriangleMesh.h"

#include "Core/ParallelChunks.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ink
{

namespace
{

float usable(float density)
{
  return std::isfinite(density) && density > 0.0f ? density : 0.0f;
}

glm::dvec3 cross(const TriangleMesh& mesh, std::size_t triangle)
{
  const auto& [a, b, c] = mesh.triangles[triangle];
  return glm::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
}

/// Turns values[1 ...] into prefix sums.
void addUp(std::vector<double>& values)
{
  const std::size_t count = values.size() - 1;
  std::vector<double> before(chunksOf(count) + 1);
  parallelForChunks(count,
    [&](std::size_t chunk, std::size_t begin, std::size_t end)
    {
      std::partial_sum(&values[1 + begin], &values[end] + 1, &values[1 + begin]);
      before[chunk + 1] = values[end];
    });
  std::partial_sum(before.begin(), before.end(), before.begin());
  parallelForChunks(count,
    [&](std::size_t chunk, std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        values[1 + i] += before[chunk];
      }
    });
}

} // namespace

glm::vec3 TriangleMesh::density(std::size_t triangle) const
{
  if (!this->pointDensity.empty())
  {
    const auto& [a, b, c] = this->triangles[triangle];
    return { usable(this->pointDensity[a]), usable(this->pointDensity[b]), usable(this->pointDensity[c]) };
  }
  return glm::vec3(this->triangleDensity.empty() ? 1.0f : usable(this->triangleDensity[triangle]));
}

glm::dvec3 positionOf(const TriangleMesh& mesh, const SurfaceSample& sample)
{
  const auto& [a, b, c] = mesh.triangles[sample.triangle];
  const glm::dvec3 origin = mesh.points[a];
  return origin + static_cast<double>(sample.b1) * (mesh.points[b] - origin) +
    static_cast<double>(sample.b2) * (mesh.points[c] - origin);
}

double areaOf(const TriangleMesh& mesh, std::size_t triangle)
{
  const double area = 0.5 * glm::length(cross(mesh, triangle));
  return std::isfinite(area) ? area : 0.0;
}

float densityOf(const TriangleMesh& mesh, const SurfaceSample& sample)
{
  const glm::vec3 corners = mesh.density(sample.triangle);
  return corners.x + sample.b1 * (corners.y - corners.x) + sample.b2 * (corners.z - corners.x);
}

CumulativeArea cumulateArea(const TriangleMesh& mesh)
{
  const std::size_t count = mesh.triangles.size();
  CumulativeArea result;
  result.area.resize(count + 1);
  result.mass.resize(mesh.hasDensity() ? count + 1 : 0);
  parallelForEach(count,
    [&](std::size_t i)
    {
      result.area[i + 1] = areaOf(mesh, i);
      if (!result.mass.empty())
      {
        const glm::dvec3 density = mesh.density(i);
        result.mass[i + 1] = result.area[i + 1] * (density.x + density.y + density.z) / 3.0;
      }
    });
  addUp(result.area);
  if (!result.mass.empty())
  {
    addUp(result.mass);
  }
  return result;
}

void placeNormals(const TriangleMesh& mesh, std::span<const glm::vec3> normals,
  std::span<const SurfaceSample> samples, std::span<float> result)
{
  parallelForEach(samples.size(),
    [&](std::size_t i)
    {
      const SurfaceSample& sample = samples[i];
      glm::vec3 normal(0.0f);
      if (!normals.empty())
      {
        const auto& [a, b, c] = mesh.triangles[sample.triangle];
        normal =
          (1.0f - sample.b1 - sample.b2) * normals[a] + sample.b1 * normals[b] + sample.b2 * normals[c];
      }
      float length = glm::length(normal);
      // Unit normals of opposite sides cancel out up to rounding. False for NaN.
      if (!(length > 1e-3f && std::isfinite(length)))
      {
        const glm::dvec3 own = cross(mesh, sample.triangle);
        const double size = glm::length(own);
        normal = size > 0.0 && std::isfinite(size) ? glm::vec3(own / size) : glm::vec3(0.0f, 0.0f, 1.0f);
        length = 1.0f;
      }
      normal /= length;
      std::copy(&normal.x, &normal.x + 3, &result[3 * i]);
    });
}

} // namespace ink
