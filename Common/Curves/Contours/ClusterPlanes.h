// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/LargePages.h"
#include "Core/Prefetch.h"
#include "Curves/Contours/Eye.h"
#include "Curves/Contours/NormalClusters.h"
#include "Curves/Contours/UnitBall.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// Planes n.x = n.p of the items of each cluster of NormalClusters, which tell of almost all elements whether
/// an eye sees their items from both sides. What belongs to a cluster lies in two lines of cache: planes as
/// deviations from their mean in bytes, each once however many elements share it. Clusters with more than 16
/// planes tell nothing.
class ClusterPlanes
{
public:
  ClusterPlanes() = default;
  /// @param itemsOf as of NormalClusters, with as many items for each element, up to 16
  ClusterPlanes(std::size_t elements, std::size_t itemsPerElement, const UnitBall& ball,
    const NormalClusters::ItemsOf& itemsOf);

private:
  static constexpr std::size_t most = 16; ///< planes of a cluster

  struct alignas(64) Cluster
  {
    float normal[3]; ///< the mean, with the offset below
    float offset;
    float normalStep; ///< of the deviations; NaN where there are too many planes
    float offsetStep;
    std::uint16_t planesOf[NormalClusters::clusterSize]; ///< a bit for each plane of an element
    std::uint32_t deviations[most]; ///< signed bytes: of the normal's x, y and z, the highest of the offset
  };

public:
  /// An eye among the planes.
  class View
  {
  public:
    View(const ClusterPlanes& planes, const Eye& eye);

    /// The elements that may have items with n.v < 0 and n.v >= 0, a bit for each: all that do, and few
    /// others.
    std::uint32_t straddling(std::size_t cluster) const;

    void prefetch(std::size_t cluster) const { prefetchObject(this->Clusters[cluster]); }

  private:
    const Cluster* Clusters;
    float Position[3];
    float Perspective;
    float Slack;
    float Span; ///< the sum of the position's magnitudes
  };

private:
  static Cluster around(std::span<const NormalCone::Item> items, std::size_t itemsPerElement);

  UnitBall Ball;
  LargePageVector<Cluster> Clusters;
};

} // namespace ink
