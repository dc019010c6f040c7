// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curvature/RingOrder.h"
#include "Mesh/Seams.h"
#include "Mesh/TriangleMesh.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// The ring of each point of a mesh, in flat arrays. Triangles with a point that is not finite, or that
/// occurs twice, are left out, and of triangles with the same corners all but the first are. Where seams are
/// joined, points of borders that coincide (coincidentPoints) count as one site, known by the first of them;
/// all other points are sites of their own.
class SurfaceRings
{
public:
  /// @throws std::invalid_argument if a triangle names a point that does not exist
  explicit SurfaceRings(const TriangleMesh& mesh, Seams seams = Seams::Joined);

  std::size_t size() const { return this->Shapes.size(); }
  /// A point's site.
  std::uint32_t site(std::size_t point) const
  {
    return this->Sites.empty() ? static_cast<std::uint32_t>(point) : this->Sites[point];
  }
  RingShape shape(std::size_t site) const { return this->Shapes[site]; }
  /// See appendRing.
  std::span<const std::uint32_t> ring(std::size_t site) const
  {
    return { this->Neighbors.data() + this->FirstNeighbor[site],
      this->Neighbors.data() + this->FirstNeighbor[site + 1] };
  }
  /// The sum of the area vectors of the triangles at a site; zero if they cancel out or there are none.
  glm::dvec3 areaVector(std::span<const glm::dvec3> points, std::size_t site) const;

private:
  /// Fills all that follows from the triangles, after leaving out those that repeat others.
  void connect(std::size_t pointCount);
  void indexCorners(std::size_t pointCount);
  void fillRings();
  bool weldBorders(std::span<const glm::dvec3> points);
  template <class Visit>
  void visitLinks(std::size_t site, const Visit& visit) const;

  std::vector<Triangle> Triangles;  // of sites
  std::vector<std::uint32_t> Sites; // of each point; empty if each is its own
  std::vector<std::size_t> FirstCorner;
  std::vector<std::uint32_t> Corners; // of each site: its triangles
  std::vector<RingShape> Shapes;
  std::vector<std::size_t> FirstNeighbor;
  std::vector<std::uint32_t> Neighbors;
};

} // namespace ink
