// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mesh/GeodesicUnfolding.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace ink
{

/// A mesh's surface in bins no wider than about a sample's radius, each with the discs that overlap it. A bin
/// is a triangle or, where triangles are large, a square cell of one. Lengths are in units of the smallest
/// radius.
///
/// A disc is the part of the surface within a sample's radius, unfolded into a triangle's plane (see
/// GeodesicUnfolding). Bins inside one disc are covered, and drop their discs.
///
/// Threads may add discs and query bins concurrently as long as they work far from each other.
class PoissonDiskBins
{
public:
  /// Relative to the radius: a disc that touches a narrower triangle covers all of it.
  static constexpr float smallest = 0.06f;

  struct Disc
  {
    glm::vec3 center; // in the plane of the bin's triangle
    float radius;
    std::uint32_t next;
  };

  /// The state of one thread.
  class Workspace
  {
  private:
    friend class PoissonDiskBins;
    GeodesicUnfolding::Front Front;
    std::uint32_t FreeDiscs = nothing;
    std::uint32_t NextDisc = 0;
    std::uint32_t EndOfDiscs = 0;
  };

  /// @param points in units of the smallest radius
  /// @param radii the smallest in each triangle, at least 1; 0: no samples there. Empty: 1 everywhere.
  /// @throws std::invalid_argument if there would be 2^30 bins or more
  PoissonDiskBins(
    std::span<const glm::vec3> points, std::span<const Triangle> triangles, std::span<const float> radii);

  /// Whether all of a triangle is known to be covered; if not, its bins may still be.
  bool isCovered(std::uint32_t triangle) const
  {
    const std::uint32_t tag = this->tagOf(triangle);
    return tag == nothing || (!(tag & isGrid) && this->Heads[tag & ~isSmall] == covered);
  }

  /// Whether a sample of that radius at that position would be too close to others.
  bool isTaken(std::uint32_t triangle, const glm::vec3& position, float radius) const;

  /// Adds a sample's disc to all bins that it overlaps.
  void add(const GeodesicUnfolding::SurfacePoint& center, float radius, Workspace& workspace);

  /// A bin that is not covered.
  struct Open
  {
    std::uint32_t triangle;
    std::uint32_t bin;
  };
  /// Appends all open bins of a triangle.
  void listOpen(std::uint32_t triangle, std::vector<Open>& open) const;
  bool isOpen(const Open& bin) const { return this->Heads[bin.bin] != covered; }
  /// Sets `discs` to those that overlap a bin.
  void listDiscs(const Open& bin, std::vector<Disc>& discs) const;
  /// A bin's convex outline in its triangle's plane; at most seven corners.
  struct Outline
  {
    std::array<glm::vec3, 8> corners;
    std::array<glm::vec2, 8> barycentric; ///< b1 and b2 of a SurfaceSample
    int count = 0;
  };
  Outline outline(const Open& bin) const;
  /// A position in or next to a bin.
  glm::vec3 cornerOf(const Open& bin) const;
  /// Whether a bin is narrower than `smallest`.
  bool isTiny(std::uint32_t triangle) const { return (this->tagOf(triangle) & isSmall) != 0; }

  /// Calls body(workspace) with a workspace that no other thread uses meanwhile.
  template <class Body>
  void with(const Body& body)
  {
    std::unique_ptr<Workspace> mine = this->takeWorkspace();
    body(*mine);
    this->giveBack(std::move(mine));
  }

private:
  static constexpr std::uint32_t nothing = ~0u;
  static constexpr std::uint32_t covered = ~0u - 1;
  // Flags of a facet's tag, whose other bits are the index of a grid, or of the triangle's only bin.
  static constexpr std::uint32_t isGrid = 1u << 31;
  static constexpr std::uint32_t isSmall = 1u << 30;
  static constexpr int discBits = 16;

  /// The square bins of a triangle, aligned with its longest edge.
  struct Grid
  {
    glm::vec3 origin;
    glm::vec3 right; // unit
    glm::vec3 up;    // unit
    float cell;
    std::uint32_t firstBin;
    std::uint32_t columns;
    std::uint32_t rows;
  };

  Disc& disc(std::uint32_t id) const { return this->Discs[id >> discBits][id & ((1u << discBits) - 1)]; }
  std::uint32_t binAt(std::uint32_t tag, const glm::vec3& position) const;
  void addTo(std::uint32_t bin, const glm::vec3& center, float radius, Workspace& workspace);
  void cover(std::uint32_t bin, Workspace& workspace);
  void addToGrid(const Grid& grid, float least, const glm::vec3& center, float radius, Workspace& workspace);
  std::unique_ptr<Workspace> takeWorkspace();
  void giveBack(std::unique_ptr<Workspace> workspace);

  std::uint32_t tagOf(std::uint32_t triangle) const { return this->Unfolding.facets()[triangle].tag; }

  std::span<const float> Radii;
  GeodesicUnfolding Unfolding; // each facet's tag locates its bins
  std::vector<Grid> Grids;
  std::vector<std::uint32_t> Heads; // the first disc of each bin
  std::vector<std::unique_ptr<Disc[]>> Discs;
  std::uint32_t DiscBlocks = 0;
  std::vector<std::unique_ptr<Workspace>> Idle;
  std::mutex Lock;
};

} // namespace ink
