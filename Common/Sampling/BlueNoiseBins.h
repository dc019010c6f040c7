#pragma once

#include "Sampling/SurfaceUnfolding.h"

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

/// A mesh's surface in bins no wider than about a sample's radius, each with the discs that reach into it:
/// triangles, or where they are large, squares of them. Lengths are in units of the least radius.
///
/// A disc is the surroundings of a sample, closer than its radius, laid into a triangle's plane (see
/// SurfaceUnfolding). Bins that lie in one disc are covered, and forget their discs.
///
/// Threads may add discs and look at bins at the same time as long as these are far from each other.
class BlueNoiseBins
{
public:
  /// Of the radius: triangles narrower than this are covered wholly by what touches them.
  static constexpr float smallest = 0.06f;

  struct Disc
  {
    glm::vec3 center; // in the plane of the triangle that it is seen from
    float radius;
    std::uint32_t next;
  };

  /// What one thread works with.
  class Workspace
  {
  private:
    friend class BlueNoiseBins;
    SurfaceUnfolding::Front Front;
    std::uint32_t FreeDiscs = nothing;
    std::uint32_t NextDisc = 0;
    std::uint32_t EndOfDiscs = 0;
  };

  /// @param points scaled
  /// @param radii the least in each triangle, at least 1; 0: no samples there. Empty: 1 all over.
  /// @throw std::invalid_argument if there would be 2^30 bins or more
  BlueNoiseBins(
    std::span<const glm::vec3> points, std::span<const Triangle> triangles, std::span<const float> radii);

  /// Wholly covered; where not, bins say more.
  bool isCovered(std::uint32_t triangle) const
  {
    const std::uint32_t place = this->place(triangle);
    return place == nothing || (!(place & isGrid) && this->Heads[place & ~isSmall] == covered);
  }

  /// Whether a sample of a radius at a place would be too near to others.
  bool isTaken(std::uint32_t triangle, const glm::vec3& position, float radius) const;

  /// Adds a sample's disc to all bins that it reaches.
  void add(const SurfaceUnfolding::Place& place, float radius, Workspace& workspace);

  /// One bin that is not covered.
  struct Open
  {
    std::uint32_t triangle;
    std::uint32_t bin;
  };
  /// All of a triangle's are appended.
  void listOpen(std::uint32_t triangle, std::vector<Open>& open) const;
  bool isOpen(const Open& bin) const { return this->Heads[bin.bin] != covered; }
  /// The discs that reach into a bin, into `discs`.
  void listDiscs(const Open& bin, std::vector<Disc>& discs) const;
  /// A bin's convex outline in its triangle's plane; at most seven corners.
  struct Outline
  {
    std::array<glm::vec3, 8> corners;
    std::array<glm::vec2, 8> barycentric; ///< b1 and b2 of a SurfaceSample
    int count = 0;
  };
  Outline outline(const Open& bin) const;
  /// A place in or next to a bin.
  glm::vec3 placeOf(const Open& bin) const;
  /// Whether a bin is narrower than `smallest`.
  bool isTiny(std::uint32_t triangle) const { return (this->place(triangle) & isSmall) != 0; }

  /// Calls body(workspace) with one that no other thread has meanwhile.
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
  // Of a facet's tag: the rest is the number of a grid, or of the triangle's one bin.
  static constexpr std::uint32_t isGrid = 1u << 31;
  static constexpr std::uint32_t isSmall = 1u << 30;
  static constexpr int discBits = 16;

  /// Squares that a triangle is cut into, along its longest edge.
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

  Disc& disc(std::uint32_t name) const
  {
    return this->Discs[name >> discBits][name & ((1u << discBits) - 1)];
  }
  std::uint32_t binAt(std::uint32_t place, const glm::vec3& position) const;
  void addTo(std::uint32_t bin, const glm::vec3& center, float radius, Workspace& workspace);
  void cover(std::uint32_t bin, Workspace& workspace);
  void addToGrid(const Grid& grid, float limit, const glm::vec3& center, float radius, Workspace& workspace);
  std::unique_ptr<Workspace> takeWorkspace();
  void giveBack(std::unique_ptr<Workspace> workspace);

  std::uint32_t place(std::uint32_t triangle) const { return this->Unfolding.facets()[triangle].tag; }

  std::span<const float> Radii;
  SurfaceUnfolding Unfolding; // each facet's tag says where its bins are
  std::vector<Grid> Grids;
  std::vector<std::uint32_t> Heads; // of each bin: its first disc
  std::vector<std::unique_ptr<Disc[]>> Discs;
  std::uint32_t DiscBlocks = 0;
  std::vector<std::unique_ptr<Workspace>> Idle;
  std::mutex Lock;
};

} // namespace ink
