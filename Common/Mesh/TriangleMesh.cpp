// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/TriangleMesh.h"

#include "Core/ParallelFor.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace ink
{

namespace
{

// Sums are taken over blocks of this size, so that they do not depend on the number of threads.
constexpr std::size_t blockSize = 1 << 14;

float usable(float density)
{
  return std::isfinite(density) && density > 0.0f ? density : 0.0f;
}

glm::dvec3 cross(const TriangleMesh& mesh, std::size_t triangle)
{
  const auto& [a, b, c] = mesh.triangles[triangle];
  return glm::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
}

/// Turns values[1 ...] into prefix sums; blocks[i] is the sum of block i.
void addUp(std::vector<double>& values, std::size_t blocks)
{
  std::vector<double> before(blocks + 1);
  parallelFor(blocks,
    [&](std::size_t block)
    {
      const std::size_t begin = 1 + block * blockSize;
      const std::size_t end = std::min(begin + blockSize, values.size());
      for (std::size_t i = begin + 1; i < end; ++i)
      {
        values[i] += values[i - 1];
      }
      before[block + 1] = values[end - 1];
    });
  for (std::size_t block = 1; block <= blocks; ++block)
  {
    before[block] += before[block - 1];
  }
  parallelFor(blocks,
    [&](std::size_t block)
    {
      const std::size_t begin = 1 + block * blockSize;
      const std::size_t end = std::min(begin + blockSize, values.size());
      for (std::size_t i = begin; i < end; ++i)
      {
        values[i] += before[block];
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
  const std::size_t blocks = (count + blockSize - 1) / blockSize;
  CumulativeArea result;
  result.area.resize(count + 1);
  result.mass.resize(mesh.hasDensity() ? count + 1 : 0);
  parallelFor(blocks,
    [&](std::size_t block)
    {
      for (std::size_t i = block * blockSize; i < std::min((block + 1) * blockSize, count); ++i)
      {
        result.area[i + 1] = areaOf(mesh, i);
        if (!result.mass.empty())
        {
          const glm::dvec3 density = mesh.density(i);
          result.mass[i + 1] = result.area[i + 1] * (density.x + density.y + density.z) / 3.0;
        }
      }
    });
  addUp(result.area, blocks);
  if (!result.mass.empty())
  {
    addUp(result.mass, blocks);
  }
  return result;
}

void placeNormals(const TriangleMesh& mesh, std::span<const glm::vec3> normals,
  std::span<const SurfaceSample> samples, std::span<float> result)
{
  const std::size_t blocks = (samples.size() + blockSize - 1) / blockSize;
  parallelFor(blocks,
    [&](std::size_t block)
    {
      for (std::size_t i = block * blockSize; i < std::min((block + 1) * blockSize, samples.size()); ++i)
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
      }
    });
}

} // namespace ink
