// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mesh/TriangleMesh.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace ink
{

/// A position on a mesh by a triangle and barycentric coordinates in double precision, which add up to 1.
struct MeshPoint
{
  std::uint32_t triangle = 0;
  glm::dvec3 weights{ 1.0, 0.0, 0.0 }; ///< of the triangle's corners
};

/// A triangle laid into a plane: corner 0 is at the origin, corner 1 at (length, 0), corner 2 at (x2, y2).
struct TriangleChart
{
  glm::dvec3 origin;
  glm::dvec3 axisX; ///< unit, along the edge from corner 0 to 1
  glm::dvec3 axisY; ///< unit, to the side of corner 2
  double length;
  double x2;
  double y2; ///< above 0

  TriangleChart(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

  glm::dvec3 position(const glm::dvec3& weights) const
  {
    return this->origin + (weights.y * this->length + weights.z * this->x2) * this->axisX +
      (weights.z * this->y2) * this->axisY;
  }
  /// How barycentric coordinates change along a vector in the plane.
  glm::dvec3 rates(double x, double y) const
  {
    const double third = y / this->y2;
    const double second = (x - third * this->x2) / this->length;
    return { -second - third, second, third };
  }
  glm::dvec2 corner(std::uint32_t corner) const
  {
    return corner == 0 ? glm::dvec2(0.0)
      : corner == 1    ? glm::dvec2(this->length, 0.0)
                       : glm::dvec2(this->x2, this->y2);
  }
  glm::dvec3 normal() const;
  /// The sum of the three sides.
  double perimeter() const;
};

/// A mesh to move about on: which triangle lies across an edge, and what bounds it.
///
/// Edges are numbered by triangle: edge e of a triangle runs from its corner e to the next one. Points that
/// coincide (coincidentPoints) count as one; triangles with two such corners, and those without area, are
/// left out. One cannot cross borders, edges of more than two triangles, and feature edges.
class MeshNavigation
{
public:
  static constexpr std::uint32_t border = std::numeric_limits<std::uint32_t>::max();

  /// @param mesh is viewed: its arrays have to live as long
  /// @param featureAngle in degrees: edges whose triangles' normals enclose more cannot be crossed; 180: none
  /// @throws std::invalid_argument where a triangle names a point that does not exist
  MeshNavigation(const TriangleMesh& mesh, double featureAngle);

  /// Of some of the triangles, in their order: to the others there are borders.
  /// @param mesh of these triangles and the same points; viewed
  MeshNavigation part(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles) const;

  /// Makes edges that are features ones that cannot be crossed, as the constructor does.
  /// @param angle in degrees, as there
  /// @param reach in world units; above 0 an edge is a feature only if the surface is bent by more than the
  ///   angle there also from a distance: between where one gets going straight away from it to both sides.
  ///   So the steep triangles of a rough surface are none.
  void cutFeatures(double angle, double reach);

  /// Takes back what edges of a triangle cannot be crossed any more. The triangles across them have to be
  /// restored as well.
  /// @param before of the same mesh
  void restore(std::uint32_t triangle, const MeshNavigation& before)
  {
    const std::size_t first = 3 * std::size_t(triangle);
    std::copy_n(before.Links.begin() + static_cast<std::ptrdiff_t>(first), 3,
      this->Links.begin() + static_cast<std::ptrdiff_t>(first));
  }

  const TriangleMesh& mesh() const { return this->Mesh; }
  /// Views another mesh instead, whose triangles have the same corners, but other points in common.
  void setMesh(const TriangleMesh& mesh) { this->Mesh = mesh; }
  bool isUsable(std::uint32_t triangle) const { return this->Usable[triangle] != 0; }
  double area() const { return this->Area; }
  /// Of the triangles that have an area.
  const glm::dvec3& lower() const { return this->Lower; }
  const glm::dvec3& upper() const { return this->Upper; }

  TriangleChart chart(std::uint32_t triangle) const
  {
    const auto& [a, b, c] = this->Mesh.triangles[triangle];
    return { this->Mesh.points[a], this->Mesh.points[b], this->Mesh.points[c] };
  }
  glm::dvec3 position(const MeshPoint& point) const;
  /// The mesh's point at the corner of a triangle with the largest weight.
  std::uint32_t nearestPoint(const MeshPoint& point) const;

  /// What lies across an edge.
  struct Neighbor
  {
    std::uint32_t triangle;
    std::uint32_t edge; ///< the same edge there
    bool opposed;       ///< whether that triangle runs along the edge the other way, as on oriented surfaces
    /// The corner there that is the corner `edge` here (`second` 0) or the next one (1).
    std::uint32_t corner(std::uint32_t second) const
    {
      return (this->edge + (this->opposed ? 1 - second : second)) % 3;
    }
  };
  std::optional<Neighbor> across(std::uint32_t triangle, std::uint32_t edge) const
  {
    const std::uint32_t link = this->Links[3 * std::size_t(triangle) + edge];
    if (link == border)
    {
      return std::nullopt;
    }
    return Neighbor{ link / 6, link / 2 % 3, link % 2 != 0 };
  }

  /// Moves a point on an edge to the triangle across it, and turns a vector in the plane of the first
  /// triangle about the edge into that of the second.
  /// @param chart of the point's triangle
  /// @param vector by the axes of the chart
  /// @return false, and nothing changed, if the edge cannot be crossed
  bool cross(MeshPoint& point, TriangleChart& chart, std::uint32_t edge, glm::dvec2& vector) const;

  struct Arrival
  {
    MeshPoint at;
    glm::dvec3 heading; ///< unit, in the triangle's plane
  };
  /// Where one gets going straight on along the surface, as on a geodesic.
  /// @param direction of any length; its part in the triangle's plane counts
  /// @return nothing if the surface ends on the way
  std::optional<Arrival> walk(MeshPoint from, const glm::dvec3& direction, double distance) const;

private:
  explicit MeshNavigation(const TriangleMesh& mesh);
  /// Sets the area and the bounds, from the usable triangles, if there are any.
  bool measure();
  /// Whether the surface goes straight on over an edge, seen from a distance.
  bool isStraight(std::uint32_t triangle, std::uint32_t edge, const Neighbor& other, double reach,
    double leastCosine) const;

  TriangleMesh Mesh;
  std::vector<std::uint32_t> Links; ///< 6 triangle + 2 edge + opposed, or border; one per edge
  std::vector<std::uint8_t> Usable; ///< one per triangle
  double Area = 0.0;
  glm::dvec3 Lower{ 0.0 };
  glm::dvec3 Upper{ 0.0 };
};

} // namespace ink
