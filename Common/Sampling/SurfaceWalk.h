#pragma once

#include "Sampling/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// Distances along a surface: near points are near only if one can walk from one to the other on the mesh.
///
/// The way is cut out of the surface by the plane through both points and along the mean of their normals,
/// triangle by triangle: an upper bound of the geodesic distance, and the distance itself where the surface
/// is flat or the cut is along a symmetry. Two sides of a thin sheet, layers of a roll and separate pieces of
/// a mesh are as far apart as the mesh says, however near in space.
class SurfaceWalk
{
public:
  static constexpr float unreachable = 1e30f;

  struct Place
  {
    glm::vec3 position;
    std::uint32_t triangle;
  };

  /// @param points the mesh's points, in any unit and frame. Kept as a reference, as are the triangles.
  /// Edges are joined by their points' indices, and where that leaves the mesh open, by equal positions.
  SurfaceWalk(std::span<const glm::vec3> points, std::span<const Triangle> triangles);

  /// The length of the way, or `unreachable` where it is not shorter than `limit` or where the points lie
  /// straight above each other. At the mesh's border the way goes along it until it can go on; at an edge of
  /// three or more triangles the rest is taken as straight.
  float distance(const Place& from, const Place& to, float limit) const;

  /// Of a triangle, unit; 0 for one without area.
  const glm::vec3& normal(std::uint32_t triangle) const { return this->Normals[triangle]; }

private:
  struct Cut; // a plane
  struct Step // into a triangle, across an edge
  {
    std::uint32_t edge;
    glm::vec3 place;
    float length;
  };
  float walk(const Place& from, const Place& to, const Cut& cut, bool forward, float limit) const;
  Step followBorder(const Step& from, const Cut& cut, bool upwards, float limit) const;
  std::uint32_t nextOnBorder(std::uint32_t edge, const glm::vec3& pivot) const;
  const glm::vec3& edgeEnd(std::uint32_t edge, bool upper) const;
  void join(std::span<const std::uint32_t> pointNames);

  std::span<const glm::vec3> Points;
  std::span<const Triangle> Triangles;
  std::vector<glm::vec3> Normals;
  // Of edge 3 t + e, from corner e of triangle t to the next: the same edge in the triangle across.
  std::vector<std::uint32_t> Across;
};

} // namespace ink
