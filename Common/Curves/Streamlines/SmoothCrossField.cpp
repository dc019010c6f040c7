// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Streamlines/SmoothCrossField.h"

#include "Core/ParallelChunks.h"
#include "Curvature/PrincipalCurvature.h"
#include "Curvature/SurfaceRings.h"
#include "Curvature/TurnedTangent.h"
#include "Mesh/OnePerPoint.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>

namespace ink
{

namespace
{

using ComplexFloat = std::complex<float>;

constexpr std::size_t pointsPerChunk = 1 << 12;
/// From which umbilic measure on directions are smoothed.
constexpr float firstSmoothed = 0.5f;

/// To the power of four, length 1.
ComplexFloat fourfold(const glm::dvec3& direction, const glm::dvec3& axisX, const glm::dvec3& axisY)
{
  const std::complex<double> z(glm::dot(direction, axisX), glm::dot(direction, axisY));
  const double size = std::abs(z);
  if (!(size > 1e-12))
  {
    return {};
  }
  const std::complex<double> squared = (z / size) * (z / size);
  return ComplexFloat(squared * squared);
}

/// Faster than operator*, which looks for infinite parts.
ComplexFloat product(const ComplexFloat& a, const ComplexFloat& b)
{
  return { a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real() };
}

} // namespace

std::vector<glm::dvec3> smoothCrossField(const TriangleMesh& mesh, std::span<const glm::vec3> normals,
  std::span<const glm::dvec3> directions, std::span<const float> umbilics, int iterations,
  const Progress& progress, Seams seams)
{
  const std::size_t count = mesh.points.size();
  checkOnePerPoint(mesh, normals.size(), "normals");
  checkOnePerPoint(mesh, directions.size(), "directions");
  checkOnePerPoint(mesh, umbilics.size(), "umbilic measures");
  const SurfaceRings rings(mesh, seams);
  const auto ringOf = [&](std::size_t point) { return rings.ring(rings.site(point)); };
  std::vector<std::size_t> offsets(count + 1); // of each point's turns
  for (std::size_t i = 0; i < count; ++i)
  {
    offsets[i + 1] = offsets[i] + ringOf(i).size();
  }
  std::vector<glm::dvec3> axes(count); // x axis of each tangent plane
  std::vector<ComplexFloat> now(count);
  std::vector<float> share(count); // of the neighbors in the mean
  std::vector<ComplexFloat> turns(offsets.back());
  const auto forPoints = [&](const auto& body) { parallelForEach(count, body, pointsPerChunk); };
  forPoints(
    [&](std::size_t i)
    {
      const glm::dvec3 normal(normals[i]);
      if (normal == glm::dvec3(0.0))
      {
        return;
      }
      axes[i] = tangentAxes(normal)[0];
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
      const std::span<const std::uint32_t> ring = ringOf(i);
      for (std::size_t n = 0; share[i] > 0.0f && n < ring.size(); ++n)
      {
        const std::uint32_t other = ring[n];
        if (axes[other] != glm::dvec3(0.0))
        {
          turns[offsets[i] + n] = fourfold(turnedTangent(axes[other], glm::dvec3(normals[other]), normal),
            axes[i], glm::cross(normal, axes[i]));
        }
      }
    });
  std::vector<ComplexFloat> next = now;
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    if (progress && !progress(static_cast<double>(iteration) / iterations))
    {
      return { directions.begin(), directions.end() };
    }
    forPoints(
      [&](std::size_t i)
      {
        const std::span<const std::uint32_t> ring = ringOf(i);
        if (!(share[i] > 0.0f) || ring.empty())
        {
          return;
        }
        ComplexFloat sum;
        for (std::size_t n = 0; n < ring.size(); ++n)
        {
          sum += product(turns[offsets[i] + n], now[ring[n]]);
        }
        next[i] = (1.0f - share[i]) * now[i] + share[i] / static_cast<float>(ring.size()) * sum;
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
