// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curvature/FieldCurvature.h"
#include "HashNoise.h"
#include "SampledMeshes.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace ink::test
{

/// A mesh whose points lie on a surface of known curvature, or did before they were displaced.
struct MeshWithCurvature
{
  Mesh mesh;
  std::vector<PrincipalCurvature> exact; ///< one per point
};

/// 1 - (x/a)^2 - (y/b)^2 - (z/c)^2: greater inside, so that normals point out.
struct EllipsoidField
{
  glm::dvec3 radii;

  double value(const glm::dvec3& p) const { return 1.0 - glm::dot(p / this->radii, p / this->radii); }
  glm::dvec3 gradient(const glm::dvec3& p) const { return -2.0 * p / (this->radii * this->radii); }
  glm::dmat3 hessian(const glm::dvec3&) const
  {
    const glm::dvec3 d = -2.0 / (this->radii * this->radii);
    return glm::dmat3(d.x, 0.0, 0.0, 0.0, d.y, 0.0, 0.0, 0.0, d.z);
  }
};

/// A torus around the z axis, of columns around it and rows around the tube, closed.
/// @param jitter by how many steps points are displaced at random along the surface, below 0.5; if not 0,
///   quads are cut along a random diagonal
inline MeshWithCurvature closedTorus(double radius, double tube, std::uint32_t columns, std::uint32_t rows,
  double jitter = 0.0, double noise = 0.0)
{
  MeshWithCurvature result;
  for (std::uint32_t row = 0; row < rows; ++row)
  {
    for (std::uint32_t column = 0; column < columns; ++column)
    {
      const std::uint32_t index = row * columns + column;
      const auto shift = [&](std::uint64_t seed)
      { return jitter * (2.0 * testing::hashUniform(seed, index) - 1.0); };
      const double around = 2.0 * std::numbers::pi * (column + shift(1)) / columns;
      const double across = 2.0 * std::numbers::pi * (row + shift(2)) / rows;
      const glm::dvec3 out(std::cos(around), std::sin(around), 0.0);
      const glm::dvec3 along(-out.y, out.x, 0.0);
      const glm::dvec3 normal = std::cos(across) * out + std::sin(across) * glm::dvec3(0.0, 0.0, 1.0);
      result.mesh.points.push_back(radius * out + (tube + noise * testing::hashNormal(7, index)) * normal);
      result.exact.push_back({ 1.0 / tube, std::cos(across) / (radius + tube * std::cos(across)),
        glm::cross(along, normal), along });
      const std::uint32_t nextColumn = (column + 1) % columns;
      const std::uint32_t nextRow = (row + 1) % rows;
      const std::array<std::uint32_t, 4> quad{ index, row * columns + nextColumn,
        nextRow * columns + nextColumn, nextRow * columns + column };
      const std::uint32_t first = jitter > 0.0 && testing::hashUniform(3, index) < 0.5 ? 1 : 0;
      result.mesh.triangles.push_back({ quad[first], quad[first + 1], quad[first + 2] });
      result.mesh.triangles.push_back({ quad[first], quad[first + 2], quad[(first + 3) % 4] });
    }
  }
  return result;
}

/// An icosahedron whose faces are cut in four `levels` times, with points moved to the unit sphere.
inline Mesh icosphere(int levels)
{
  Mesh mesh;
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  for (const glm::dvec3& p :
    { glm::dvec3(-1, g, 0), glm::dvec3(1, g, 0), glm::dvec3(-1, -g, 0), glm::dvec3(1, -g, 0),
      glm::dvec3(0, -1, g), glm::dvec3(0, 1, g), glm::dvec3(0, -1, -g), glm::dvec3(0, 1, -g),
      glm::dvec3(g, 0, -1), glm::dvec3(g, 0, 1), glm::dvec3(-g, 0, -1), glm::dvec3(-g, 0, 1) })
  {
    mesh.points.push_back(glm::normalize(p));
  }
  mesh.triangles = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 }, { 1, 5, 9 },
    { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 }, { 3, 2, 6 },
    { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 }, { 9, 8, 1 } };
  for (int level = 0; level < levels; ++level)
  {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b)
    {
      const auto [at, isNew] =
        middles.emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.points.size()));
      if (isNew)
      {
        mesh.points.push_back(glm::normalize(mesh.points[a] + mesh.points[b]));
      }
      return at->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : mesh.triangles)
    {
      const std::uint32_t ab = middle(a, b);
      const std::uint32_t bc = middle(b, c);
      const std::uint32_t ca = middle(c, a);
      finer.insert(finer.end(), { { a, ab, ca }, { b, bc, ab }, { c, ca, bc }, { ab, bc, ca } });
    }
    mesh.triangles = std::move(finer);
  }
  return mesh;
}

/// @param noise deviation of the points along the normal, in world units
inline MeshWithCurvature ellipsoid(const glm::dvec3& radii, int levels, double noise = 0.0)
{
  MeshWithCurvature result;
  result.mesh = icosphere(levels);
  const EllipsoidField field{ radii };
  for (std::size_t i = 0; i < result.mesh.points.size(); ++i)
  {
    glm::dvec3& point = result.mesh.points[i];
    point *= radii;
    result.exact.push_back(fieldCurvature(field, point).value());
    point += noise * testing::hashNormal(7, i) * result.exact.back().normal();
  }
  return result;
}

/// Root mean squares of what differs from the exact curvature.
struct CurvatureErrors
{
  double curvature; ///< of k1 and k2, in 1 / world unit
  double angle;     ///< of direction 1, in degrees, where k1 and k2 differ; 0 on spheres
};

inline CurvatureErrors curvatureErrors(
  const std::vector<PrincipalCurvature>& exact, const std::vector<PrincipalCurvature>& estimated)
{
  double squares = 0.0;
  double angles = 0.0;
  double directed = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    const PrincipalCurvature& e = exact[i];
    const PrincipalCurvature& c = estimated[i];
    squares += 0.5 * ((c.k1 - e.k1) * (c.k1 - e.k1) + (c.k2 - e.k2) * (c.k2 - e.k2));
    // Within this of an umbilic, directions say nothing.
    constexpr double undirected = 0.9;
    if (e.umbilicMeasure() < undirected)
    {
      const double cosine = std::abs(glm::dot(e.direction1, c.direction1));
      const double angle = std::acos(std::min(cosine, 1.0)) * 180.0 / std::numbers::pi;
      angles += angle * angle;
      directed += 1.0;
    }
  }
  return { std::sqrt(squares / static_cast<double>(exact.size())),
    directed > 0.0 ? std::sqrt(angles / directed) : 0.0 };
}

} // namespace ink::test
