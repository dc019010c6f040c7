// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mesh/TriangleMesh.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// Geodesic distances: unfolds the surface around a position into a plane, triangle by triangle.
///
/// Starting at the position's triangle, triangles are visited across edges within a radius, and each gets the
/// image of the position: where it ends up when the triangles of the path are rotated about their common
/// edges into the plane of this one. The distance from a point of the triangle to the image is its distance
/// on the unfolded surface: the geodesic distance if the straight line to the image stays on the triangles of
/// the path, and close to it otherwise. Bends of less than fifteen degrees between the position and a
/// triangle are not unfolded; there the distance is Euclidean, at most 0.3 % shorter.
///
/// Two sides of a thin sheet, layers of a roll and separate components have their distance along the mesh,
/// however close in space. The search ends at the mesh's boundary; at a non-manifold edge it continues into
/// all triangles.
class GeodesicUnfolding
{
public:
  struct SurfacePoint
  {
    glm::vec3 position;
    std::uint32_t triangle;
  };

  /// The state of one thread's search, reused from one search to the next.
  class Front
  {
  private:
    friend class GeodesicUnfolding;
    struct Entry
    {
      std::uint32_t triangle;
      glm::vec3 image;
      glm::vec3 normal; // of the plane that the image was last rotated into
    };
    struct Slot
    {
      std::uint32_t triangle;
      std::uint32_t round;
    };
    void begin();
    /// Marks a triangle as visited; returns false if it was already.
    bool enter(std::uint32_t triangle)
    {
      const std::size_t mask = this->Slots.size() - 1;
      std::size_t slot = (triangle * 0x9e3779b1u >> 8) & mask;
      while (this->Slots[slot].round == this->Round)
      {
        if (this->Slots[slot].triangle == triangle)
        {
          return false;
        }
        slot = (slot + 1) & mask;
      }
      this->Slots[slot] = { triangle, this->Round };
      if (2 * ++this->Entered > this->Slots.size())
      {
        this->grow();
      }
      return true;
    }
    void grow();

    std::vector<Entry> Entries;
    std::vector<Slot> Slots = std::vector<Slot>(256);
    std::uint32_t Round = 0;
    std::size_t Entered = 0;
  };

  /// A triangle with everything that the search reads, in one cache line.
  struct alignas(64) Facet
  {
    std::array<glm::vec3, 3> corners;
    glm::vec3 normal; ///< unit; 0 if degenerate
    /// For the edge from corner e to the next: the same edge in the next triangle, as 3 * triangle + its e
    /// there. All triangles at an edge form a ring.
    std::array<std::uint32_t, 3> across;
    std::uint32_t tag = 0; ///< the user's
  };

  /// @param points the mesh's points, in any unit and frame
  /// @param triangles faster if neighbors are close in memory
  ///
  /// Triangles are connected by point indices, and where that leaves the mesh open, by equal positions.
  GeodesicUnfolding(std::span<const glm::vec3> points, std::span<const Triangle> triangles);

  /// Calls visit(triangle, facet, image, squares) once for each triangle reached, starting with the
  /// position's own; `squares` are the squared distances of the corners to the image.
  template <class Visit>
  void visitAround(const SurfacePoint& start, float radius, Front& front, const Visit& visit) const;

  std::span<Facet> facets() { return this->Facets; }
  std::span<const Facet> facets() const { return this->Facets; }

private:
  static constexpr std::uint32_t border = ~0u;
  // The cosine of the largest bend that is not unfolded.
  static constexpr float nearlyFlat = 0.966f;

  void join(
    std::size_t pointCount, std::span<const Triangle> triangles, std::span<const std::uint32_t> pointIds);
  Front::Entry turn(const Front::Entry& from, std::uint32_t exit, std::uint32_t entry) const;
  const glm::vec3& corner(std::uint32_t edge, std::uint32_t further) const
  {
    const std::uint32_t triangle = edge / 3;
    return this->Facets[triangle].corners[(edge - 3 * triangle + further) % 3];
  }

  /// Whether the segment from a to b comes within sqrt(limit) of the origin.
  static bool isNear(const glm::vec3& a, const glm::vec3& b, float limit)
  {
    if (glm::dot(a, a) < limit || glm::dot(b, b) < limit)
    {
      return true;
    }
    const glm::vec3 edge = b - a;
    const float share = -glm::dot(a, edge) / glm::dot(edge, edge);
    const glm::vec3 nearest = a + share * edge;
    return share > 0.0f && share < 1.0f && glm::dot(nearest, nearest) < limit;
  }
  std::uint32_t following(std::uint32_t edge) const { return this->Facets[edge / 3].across[edge % 3]; }

  std::vector<Facet> Facets;
};

template <class Visit>
void GeodesicUnfolding::visitAround(
  const SurfacePoint& start, float radius, Front& front, const Visit& visit) const
{
  front.begin();
  front.enter(start.triangle);
  front.Entries.push_back({ start.triangle, start.position, this->Facets[start.triangle].normal });
  const float limit = radius * radius;
  for (std::size_t i = 0; i < front.Entries.size(); ++i)
  {
    const Front::Entry here = front.Entries[i];
    const Facet& facet = this->Facets[here.triangle];
    const glm::vec3 offsets[3] = { facet.corners[0] - here.image, facet.corners[1] - here.image,
      facet.corners[2] - here.image };
    const float squares[3] = { glm::dot(offsets[0], offsets[0]), glm::dot(offsets[1], offsets[1]),
      glm::dot(offsets[2], offsets[2]) };
    visit(here.triangle, facet, here.image, squares);
    for (std::uint32_t e = 0; e < 3; ++e)
    {
      const std::uint32_t exit = 3 * here.triangle + e;
      const std::uint32_t f = e == 2 ? 0 : e + 1;
      if (facet.across[e] == border)
      {
        continue;
      }
      // No path is shorter than the Euclidean distance.
      if (!isNear(offsets[e], offsets[f], limit) ||
        (here.image != start.position &&
          !isNear(facet.corners[e] - start.position, facet.corners[f] - start.position, limit)))
      {
        continue;
      }
      for (std::uint32_t entry = facet.across[e]; entry != exit; entry = this->following(entry))
      {
        const std::uint32_t other = entry / 3;
        if (!front.enter(other))
        {
          continue;
        }
        if (glm::dot(here.normal, this->Facets[other].normal) > nearlyFlat)
        {
          front.Entries.push_back({ other, here.image, here.normal });
        }
        else
        {
          front.Entries.push_back(this->turn(here, exit, entry));
        }
      }
    }
  }
}

} // namespace ink
