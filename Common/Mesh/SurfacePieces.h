// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mesh/TriangleMesh.h"
#include "PointSampling/CandidatePoints.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// A mesh's triangles, large ones split into pieces, in Morton order, so that neighbors on the surface are
/// mostly close in memory.
class SurfacePieces
{
public:
  /// @param mesh without a density; triangles without area are left out
  /// @param points the mesh's points relative to the center of its bounds, the frame of all positions here
  /// @param normals one per point of the mesh, which orient the triangles consistently; empty: orientation by
  ///   the order of their corners
  /// @param longest the maximum edge length of a piece
  SurfacePieces(const TriangleMesh& mesh, std::span<const glm::vec3> points,
    std::span<const glm::vec3> normals, float longest);

  /// In the mesh's own unit.
  std::span<const double> areas() const { return this->Areas; }
  std::span<const glm::vec3> middles() const { return this->Middles; }
  /// None: candidates are stratified over all of the mesh, see ProgressiveSampler.
  std::span<const std::uint64_t> ids() const { return {}; }
  float longest() const { return this->Longest; }

  /// The coordinate frame of a piece, to position samples in it.
  struct Frame
  {
    glm::vec3 origin;
    glm::vec3 along1; // to the other corners
    glm::vec3 along2;
    glm::vec3 normal; // unit; 0 if degenerate
  };
  Frame frame(std::size_t piece) const;
  /// A uniform position (b1, b2) in a piece of two uniform numbers in [0, 1).
  static glm::vec2 coordinates(float u, float v)
  {
    const float root = std::sqrt(u);
    const float b2 = root * v;
    return { root - b2, b2 };
  }
  /// A sample in coordinates of its triangle.
  SurfaceSample sample(const SpacedSample& spaced) const;

private:
  using Corners = std::array<glm::vec2, 3>; // b1 and b2 in the triangle

  Corners corners(std::size_t piece) const;

  TriangleMesh Mesh;
  std::span<const glm::vec3> Points;
  std::span<const glm::vec3> Normals;
  float Longest;
  std::vector<std::uint32_t> Order; // of each piece: its triangle,
  std::vector<std::uint32_t> Cut;   // and the corners below; none where no triangle is cut
  std::vector<Corners> CutCorners;
  std::vector<double> Areas;
  std::vector<glm::vec3> Middles;
};

} // namespace ink
