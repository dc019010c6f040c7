// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/LargePages.h"
#include "Curves/Contours/Eye.h"
#include "Curves/Contours/NormalCone.h"
#include "Curves/Contours/UnitBall.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace ink
{

/// Finds where n.v may change sign without looking at everything: clusters of elements (faces, or edges) that
/// follow each other, each bounded by a cone of its normals n, and a tree over these (Sander et al. 2000,
/// "Silhouette clipping", section 3). With v = e - p for an eye e and a point p, and a cluster's center c,
/// n.v = n.(e - c) - n.(p - c): the cone bounds the first term, the second has been bounded exactly.
class NormalClusters
{
public:
  static constexpr std::size_t clusterSize = 8; ///< elements, unless told otherwise

  /// Appends the items of elements `begin` to `end` - 1.
  using ItemsOf =
    std::function<void(std::size_t begin, std::size_t end, std::vector<NormalCone::Item>& items)>;

  NormalClusters() = default;
  /// @param size elements of a cluster
  NormalClusters(std::size_t elements, const ItemsOf& itemsOf, std::size_t size = clusterSize);

  std::size_t size() const { return this->Clusters; }

  /// Around all items.
  const UnitBall& ball() const { return this->Ball; }

  /// The clusters that may have items with n.v < 0 and n.v >= 0, in order: all that do, and few others.
  std::vector<std::uint32_t> straddling(const Eye& eye) const;

private:
  static constexpr std::size_t width = 8;

  /// Eight cones, in the coordinates of Ball: two lines of cache. Two numbers share a word, the second one in
  /// its higher half; those of the center are its higher three bytes.
  struct alignas(64) Block
  {
    std::uint32_t axisXY[width];
    std::uint32_t axisZSine[width];
    std::uint32_t bounds[width]; ///< lower, upper
    std::uint32_t center[width];
  };

  struct View;
  static void store(const NormalCone& cone, Block& block, std::size_t lane);
  static NormalCone coneOf(const Block& block, std::size_t lane);

  std::size_t Clusters = 0;
  UnitBall Ball;
  /// From the clusters up: node i of a level bounds block i of the level below.
  std::vector<LargePageVector<Block>> Levels;
  std::vector<std::size_t> Sizes; ///< of the levels, in nodes
};

} // namespace ink
