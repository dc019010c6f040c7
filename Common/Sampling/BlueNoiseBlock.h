#pragma once

#include "Sampling/SurfaceWalk.h"
#include "Sampling/TriangleMesh.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace ink
{

/// A place for a sample. Lengths here are in units of the least radius.
struct BlueNoiseDart
{
  SurfaceSample sample;
  float radius;
  glm::vec3 position;
};

/// A triangle inside one of the mesh's.
struct SurfacePart
{
  std::uint32_t triangle;
  float radius; ///< the least that a sample in it would have
  std::array<glm::vec3, 3> positions;
  std::array<glm::vec2, 3> corners; ///< b1 and b2 of a SurfaceSample

  glm::vec3 middle() const { return (this->positions[0] + this->positions[1] + this->positions[2]) / 3.0f; }
  /// From the middle to the farthest corner.
  float reach() const;
  /// Cut across the longest edge.
  std::pair<SurfacePart, SurfacePart> halves() const;
};

/// A cube of space that is filled with samples, one thread at a time; the cubes around it are either filled
/// already or left alone meanwhile. See sampleBlueNoise.
class BlueNoiseBlock
{
public:
  static constexpr float size = 16.0f;

  /// @param block the cube from size * block on
  /// @param radiusOf a sample's radius from its density
  BlueNoiseBlock(const TriangleMesh& mesh, const SurfaceWalk& walk, const glm::ivec3& block,
    const std::function<float(float)>& radiusOf);

  /// Samples that are there already, of this block and those next to it.
  void addSamples(std::span<const BlueNoiseDart> darts);

  /// Makes a sample of a dart, unless one is too near. Returns whether it did.
  bool tryDart(const BlueNoiseDart& dart);

  /// Makes samples in a part as long as there is room; `random` is the part's own.
  void fillGaps(const SurfacePart& part, std::uint64_t random);

  /// The samples made, in the order of their making.
  std::vector<BlueNoiseDart> takeDarts() { return std::move(this->Made); }

private:
  // Samples up to 1, 2, 4 ... 16 radii in cells of 1, 2, 4 ... 16 radii.
  static constexpr int levels = 5;
  struct Item
  {
    glm::vec3 position;
    float radius;
    std::uint32_t triangle;
    std::int32_t next;
  };
  struct Grid
  {
    float cell = 0.0f;
    int side = 0;                    // cells along an axis
    glm::vec3 origin;                // a cell's width outside the block
    std::vector<std::int32_t> heads; // empty: no item
    std::array<int, 6> cellsIn(const glm::vec3& position, float reach) const;
  };

  /// What is nearer to a place than a radius allows no sample.
  struct Disc
  {
    glm::vec3 position; // in the plane of the triangle that it is seen from
    float radius;
  };

  void add(const BlueNoiseDart& dart);
  bool holds(const glm::vec3& position) const;
  bool isCovered(const BlueNoiseDart& dart) const;
  /// Calls visit(item) for the samples within the smaller of their radius and `radius`, and `margin` more,
  /// until it returns true; returns whether it did.
  template <class Visit>
  bool visitNear(const glm::vec3& position, float radius, float margin, const Visit& visit) const;
  /// Collects the discs that reach into a part; returns whether one covers it.
  bool findDiscs(const SurfacePart& part, float reach);
  void fillAmongDiscs(const SurfacePart& part, std::uint64_t random);
  /// Makes a sample at a place of a part, (0, 0) to (1, 0) and (0, 1), unless one is too near.
  bool tryInPart(const SurfacePart& part, const glm::vec2& place);
  /// Sets a part's radius; returns whether samples may lie in it at all.
  bool setRadius(SurfacePart& part) const;
  bool isOutside(const SurfacePart& part) const;

  const TriangleMesh& Mesh;
  const SurfaceWalk& Walk;
  const std::function<float(float)>& RadiusOf;
  glm::vec3 Low;
  std::array<Grid, levels> Grids;
  std::vector<Item> Items;
  std::vector<BlueNoiseDart> Made;
  std::vector<Disc> Discs;
};

} // namespace ink
