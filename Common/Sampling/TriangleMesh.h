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

/// Triangles over points. Any triangles will do: those of no area, and those with a point that is not finite,
/// count as not there; neither closed, oriented nor manifold is asked for.
struct TriangleMesh
{
  std::span<const glm::dvec3> points;
  std::span<const Triangle> triangles; ///< each three indices of points
  /// Relative sampling density: one a point, linear in between; or one a triangle; or none, all the same.
  /// What is negative or not finite counts as 0.
  std::span<const float> pointDensity;
  std::span<const float> triangleDensity;

  bool hasDensity() const { return !this->pointDensity.empty() || !this->triangleDensity.empty(); }
  /// At a triangle's corners.
  glm::vec3 density(std::size_t triangle) const;
};

/// A place on a mesh that moves with it: corner 0 + b1 (corner 1 - corner 0) + b2 (corner 2 - corner 0).
struct SurfaceSample
{
  std::uint32_t triangle;
  float b1;
  float b2;

  bool operator==(const SurfaceSample&) const = default;
};

glm::dvec3 positionOf(const TriangleMesh& mesh, const SurfaceSample& sample);

/// A triangle's area, in the points' unit squared; 0 where it has none or is not finite.
double areaOf(const TriangleMesh& mesh, std::size_t triangle);

/// Density at a sample.
float densityOf(const TriangleMesh& mesh, const SurfaceSample& sample);

/// Sums over the triangles before each and, last, over all: triangles.size() + 1 values.
struct CumulativeArea
{
  std::vector<double> area;
  std::vector<double> mass; ///< of area times density; empty for a mesh without density: `area` is meant

  std::span<const double> weights() const { return this->mass.empty() ? this->area : this->mass; }
};

/// The same on any number of threads.
CumulativeArea cumulateArea(const TriangleMesh& mesh);

/// The interpolated normals of samples, unit: barycentric in `normals`, one a point of the mesh, or where
/// they are empty or cancel out the triangle's own; (0, 0, 1) where that has none.
void placeNormals(const TriangleMesh& mesh, std::span<const glm::vec3> normals,
  std::span<const SurfaceSample> samples, std::span<float> result);

} // namespace ink
