// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

using Triangle = std::array<std::uint32_t, 3>;

/// A triangle soup: the mesh need be neither closed, oriented nor manifold. Triangles without area, and those
/// with a point that is not finite, are ignored.
struct TriangleMesh
{
  std::span<const glm::dvec3> points;
  std::span<const Triangle> triangles; ///< three point indices each
  /// Relative sampling density: one per point, interpolated linearly; or one per triangle; or none: uniform.
  /// Values that are negative or not finite count as 0.
  std::span<const float> pointDensity;
  std::span<const float> triangleDensity;

  bool hasDensity() const { return !this->pointDensity.empty() || !this->triangleDensity.empty(); }
  /// At a triangle's corners.
  glm::vec3 density(std::size_t triangle) const;
};

/// A position on a mesh in barycentric coordinates: corner 0 + b1 (corner 1 - corner 0) + b2 (corner 2 -
/// corner 0).
struct SurfaceSample
{
  std::uint32_t triangle;
  float b1;
  float b2;

  bool operator==(const SurfaceSample&) const = default;
};

glm::dvec3 positionOf(const TriangleMesh& mesh, const SurfaceSample& sample);

/// A triangle's area, in the points' unit squared; 0 if it is not finite.
double areaOf(const TriangleMesh& mesh, std::size_t triangle);

/// Density at a sample.
float densityOf(const TriangleMesh& mesh, const SurfaceSample& sample);

/// Cumulative sums: over the triangles before each and, last, over all; triangles.size() + 1 values.
struct CumulativeArea
{
  std::vector<double> area;
  std::vector<double> mass; ///< of area times density; empty without density

  std::span<const double> weights() const { return this->mass.empty() ? this->area : this->mass; }
};

/// The same for any number of threads.
CumulativeArea cumulateArea(const TriangleMesh& mesh);

/// The unit normals of samples: interpolated from `normals`, one per point of the mesh, or where these are
/// empty or cancel out, those of the triangles; (0, 0, 1) for degenerate triangles.
void placeNormals(const TriangleMesh& mesh, std::span<const glm::vec3> normals,
  std::span<const SurfaceSample> samples, std::span<float> result);

} // namespace ink
