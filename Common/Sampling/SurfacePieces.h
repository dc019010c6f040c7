// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sampling/TriangleMesh.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// A mesh's triangles, those that are large cut into pieces, in Morton order: what is near on the surface is
/// mostly near in memory.
class SurfacePieces
{
public:
  /// @param mesh without a density; triangles without area are left out
  /// @param points the mesh's points, from the middle of its box: this is the frame of all that follows
  /// @param normals one a point of the mesh, that say which sides of the triangles are alike; or none: then
  /// the
  ///   order of their corners does
  /// @param longest what no edge of a piece is longer than
  SurfacePieces(const TriangleMesh& mesh, std::span<const glm::vec3> points,
    std::span<const glm::vec3> normals, float longest);

  std::size_t count() const { return this->Order.size(); }
  /// In the mesh's own unit.
  double area(std::size_t piece) const { return this->Areas[piece]; }
  const glm::vec3& middle(std::size_t piece) const { return this->Middles[piece]; }

  /// What is needed to place samples in a piece.
  struct Frame
  {
    glm::vec3 origin;
    glm::vec3 along1; // to the other corners
    glm::vec3 along2;
    glm::vec3 normal; // the plane's, unit; 0 without one
  };
  Frame frame(std::size_t piece) const;
  /// A place in a piece, origin + b1 along1 + b2 along2, as one in its triangle.
  SurfaceSample sample(std::size_t piece, float b1, float b2) const;

private:
  using Corners = std::array<glm::vec2, 3>; // b1 and b2 in the triangle

  Corners corners(std::size_t piece) const;

  TriangleMesh Mesh;
  std::span<const glm::vec3> Points;
  std::span<const glm::vec3> Normals;
  std::vector<std::uint32_t> Order; // of each piece: its triangle,
  std::vector<std::uint32_t> Cut;   // and the corners below; none where no triangle is cut
  std::vector<Corners> CutCorners;
  std::vector<double> Areas;
  std::vector<glm::vec3> Middles;
};

} // namespace ink
