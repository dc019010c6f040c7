// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/ParallelFor.h"
#include "Core/Prefetch.h"
#include "Curves/Contours/ClusterPlanes.h"
#include "Curves/Contours/ContourSegments.h"
#include "Curves/Contours/Eye.h"
#include "Curves/Contours/NormalClusters.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ink
{

/// How silhouettes are searched. The result is the same.
enum class SilhouetteSearch
{
  Hierarchy, ///< where cones and planes in float do not rule them out
  Exhaustive ///< everywhere
};

/// Elements (faces, or edges) in clusters, with what rules out most of them for an eye.
struct SilhouetteClusters
{
  std::size_t elements = 0;
  NormalClusters cones;
  ClusterPlanes planes;

  SilhouetteClusters() = default;
  /// @param itemsOf as of NormalClusters, with as many items for each element, up to 16
  SilhouetteClusters(std::size_t count, std::size_t itemsPerElement, const NormalClusters::ItemsOf& itemsOf)
    : elements(count)
    , cones(count, itemsOf)
    , planes(count, itemsPerElement, this->cones.ball(), itemsOf)
  {
  }
};

/// Finds the silhouettes of elements, in parallel.
/// @param finder finder.find(element, segments) appends those of an element; finder.prefetch(element) and,
///   later, finder.prefetchItems(element) fetch what that needs
/// @return what was found, in the order of elements
template <class Finder>
std::vector<ContourSegment> searchSilhouettes(
  const SilhouetteClusters& clusters, const Eye& eye, SilhouetteSearch search, const Finder& finder)
{
  constexpr std::size_t clusterSize = NormalClusters::clusterSize;
  constexpr std::size_t ahead = 8; // enough for memory to answer
  const bool everywhere = search == SilhouetteSearch::Exhaustive;
  std::vector<std::uint32_t> candidates;
  if (!everywhere)
  {
    candidates = clusters.cones.straddling(eye);
  }
  const ClusterPlanes::View view(clusters.planes, eye);
  constexpr std::size_t chunkSize = 256;
  const std::size_t count = everywhere ? clusters.cones.size() : candidates.size();
  std::vector<std::vector<ContourSegment>> found((count + chunkSize - 1) / chunkSize);
  parallelFor(found.size(),
    [&](std::size_t chunk)
    {
      const std::size_t begin = chunk * chunkSize;
      const std::size_t end = std::min(begin + chunkSize, count);
      std::vector<ContourSegment>& segments = found[chunk];
      if (everywhere)
      {
        for (std::size_t element = begin * clusterSize;
             element < std::min(end * clusterSize, clusters.elements); ++element)
        {
          finder.find(element, segments);
        }
        return;
      }
      std::uint32_t some[chunkSize * clusterSize + 1];
      std::size_t someCount = 0;
      for (std::size_t i = begin; i < end; ++i)
      {
        view.prefetch(candidates[std::min(i + ahead, end - 1)]);
        const auto first = static_cast<std::uint32_t>(candidates[i] * clusterSize);
        const std::uint32_t straddling = view.straddling(candidates[i]);
        for (std::uint32_t n = 0; n < clusterSize; ++n)
        {
          // Always written and sometimes kept: a branch would be guessed wrong too often.
          some[someCount] = first + n;
          someCount += straddling >> n & 1;
        }
      }
      segments.reserve(someCount);
      for (std::size_t i = 0; i < someCount; ++i)
      {
        finder.prefetch(some[std::min(i + 2 * ahead, someCount - 1)]);
        finder.prefetchItems(some[std::min(i + ahead, someCount - 1)]);
        finder.find(some[i], segments);
      }
    });
  if (found.size() == 1)
  {
    return std::move(found.front());
  }
  std::vector<ContourSegment> segments;
  std::size_t total = 0;
  for (const std::vector<ContourSegment>& part : found)
  {
    total += part.size();
  }
  segments.reserve(total);
  for (const std::vector<ContourSegment>& part : found)
  {
    segments.insert(segments.end(), part.begin(), part.end());
  }
  return segments;
}

} // namespace ink
