// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Streamlines/SmoothCrossField.h"

#include "Core/ParallelFor.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace ink
{

namespace
{

using Complex = std::complex<float>;

constexpr std::size_t blockSize = 1 << 12;
/// From which umbilic measure on directions are smoothed.
constexpr float firstSmoothed = 0.5f;

/// To the power of four, length 1.
Complex fourfold(const glm::dvec3& direction, const glm::dvec3& axisX, const glm::dvec3& axisY)
{
  const std::complex<double> z(glm::dot(direction, axisX), glm::dot(direction, axisY));
  const double size = std::abs(z);
  if (!(size > 1e-12))
  {
    return {};
  }
  const std::complex<double> squared = (z / size) * (z / size);
  return Complex(squared * squared);
}

glm::dvec3 anyTangent(const glm::dvec3& normal)
{
  const glm::dvec3 size = glm::abs(normal);
  const glm::dvec3 axis = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
    : size.y <= size.z                                         ? glm::dvec3(0, 1, 0)
                                                               : glm::dvec3(0, 0, 1);
  return glm::normalize(glm::cross(normal, axis));
}

/// A tangent vector turned by the smallest turn that brings its unit normal to another.
glm::dvec3 turned(const glm::dvec3& tangent, const glm::dvec3& from, const glm::dvec3& to)
{
  const double cosine = glm::dot(from, to);
  return cosine > -0.999 ? tangent - glm::dot(tangent, to) / (1.0 + cosine) * (from + to) : tangent;
}

/// For each point those that it has an edge with.
struct Neighbors
{
  std::vector<std::size_t> offsets;
  std::vector<std::uint32_t> points;

  explicit Neighbors(const TriangleMesh& mesh)
    : offsets(mesh.points.size() + 1)
  {
    // Both ends of a triangle's edges, so edges of two triangles count twice, as weights do.
    for (const Triangle& triangle : mesh.triangles)
    {
      for (const std::uint32_t point : triangle)
      {
        this->offsets[point + 1] += 2;
      }
    }
    for (std::size_t i = 1; i < this->offsets.size(); ++i)
    {
      this->offsets[i] += this->offsets[i - 1];
    }
    this->points.resize(this->offsets.back());
    std::vector<std::size_t> next(this->offsets.begin(), this->offsets.end() - 1);
    for (const auto& [a, b, c] : mesh.triangles)
    {
      const std::uint32_t corners[3] = { a, b, c };
      for (std::size_t i = 0; i < 3; ++i)
      {
        this->points[next[corners[i]]++] = corners[(i + 1) % 3];
        this->points[next[corners[i]]++] = corners[(i + 2) % 3];
      }
    }
  }
};

void checkSize(std::size_t found, std::size_t expected, const char* what)
{
  if (found != expected)
  {
    throw std::invalid_argument("there are " + std::to_string(found) + " " + what + " for " +
      std::to_string(expected) + " points, expected one per point");
  }
}

} // namespace

std::vector<glm::dvec3> smoothCrossField(const TriangleMesh& mesh, std::span<const glm::vec3> normals,
  std::span<const glm::dvec3> directions, std::span<const float> umbilics, int iterations,
  const Progress& progress)
{
  const std::size_t count = mesh.points.size();
  checkSize(normals.size(), count, "normals");
  checkSize(directions.size(), count, "directions");
  checkSize(umbilics.size(), count, "umbilic measures");
  const Neighbors neighbors(mesh);
  std::vector<glm::dvec3> axes(count); // x axis of each tangent plane
  std::vector<Complex> now(count);
  std::vector<float> share(count); // of the neighbors in the mean
  std::vector<Complex> turns(neighbors.points.size());
  const std::size_t blocks = (count + blockSize - 1) / blockSize;
  const auto forPoints = [&](const auto& body)
  {
    parallelFor(blocks,
      [&](std::size_t block)
      {
        for (std::size_t i = block * blockSize; i < std::min((block + 1) * blockSize, count); ++i)
        {
          body(i);
        }
      });
  };
  forPoints(
    [&](std::size_t i)
    {
      const glm::dvec3 normal(normals[i]);
      if (normal == glm::dvec3(0.0))
      {
        return;
      }
      axes[i] = anyTangent(normal);
      const float defined = directions[i] == glm::dvec3(0.0) || !std::isfinite(umbilics[i])
        ? 0.0f
        : std::clamp((1.0f - umbilics[i]) / (1.0f - firstSmoothed), 0.0f, 1.0f);
      share[i] = 1.0f - defined;
      now[i] = defined * fourfold(directions[i], axes[i], glm::cross(normal, axes[i]));
    });
  forPoints(
    [&](std::size_t i)
    {
      const glm::dvec3 normal(normals[i]);
      for (std::size_t n = neighbors.offsets[i]; share[i] > 0.0f && n < neighbors.offsets[i + 1]; ++n)
      {
        const std::uint32_t other = neighbors.points[n];
        if (axes[other] != glm::dvec3(0.0))
        {
          turns[n] = fourfold(
            turned(axes[other], glm::dvec3(normals[other]), normal), axes[i], glm::cross(normal, axes[i]));
        }
      }
    });
  std::vector<Complex> next = now;
  for (int n = 0; n < iterations; ++n)
  {
    if (progress && !progress(static_cast<double>(n) / iterations))
    {
      return { directions.begin(), directions.end() };
    }
    forPoints(
      [&](std::size_t i)
      {
        if (!(share[i] > 0.0f) || neighbors.offsets[i] == neighbors.offsets[i + 1])
        {
          return;
        }
        Complex sum;
        for (std::size_t e = neighbors.offsets[i]; e < neighbors.offsets[i + 1]; ++e)
        {
          sum += turns[e] * now[neighbors.points[e]];
        }
        const auto edges = static_cast<float>(neighbors.offsets[i + 1] - neighbors.offsets[i]);
        next[i] = (1.0f - share[i]) * now[i] + share[i] / edges * sum;
      });
    std::swap(now, next);
  }
  std::vector<glm::dvec3> result(directions.begin(), directions.end());
  forPoints(
    [&](std::size_t i)
    {
      if (!(share[i] > 0.0f) || !(std::abs(now[i]) > 0.0f))
      {
        return;
      }
      const double angle = 0.25 * std::arg(std::complex<double>(now[i]));
      const glm::dvec3 normal(normals[i]);
      const glm::dvec3 first = std::cos(angle) * axes[i] + std::sin(angle) * glm::cross(normal, axes[i]);
      const glm::dvec3 second = glm::cross(normal, first);
      const double along = glm::dot(first, directions[i]);
      const double across = glm::dot(second, directions[i]);
      // Normals are of single precision, so lengths are not quite 1.
      result[i] = glm::normalize(std::abs(along) >= std::abs(across) ? (along < 0.0 ? -first : first)
                                                                     : (across < 0.0 ? -second : second));
    });
  return result;
}

} // namespace ink
