// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/ParallelFor.h"
#include "Curves/Contours/ContourSegments.h"
#include "Curves/Contours/Eye.h"
#include "Curves/Contours/NormalClusters.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace ink
{

/// How silhouettes are searched. The result is the same.
enum class SilhouetteSearch
{
  Hierarchy, ///< in clusters that may hold one, with facing planes in float where these tell
  Exhaustive ///< everywhere, in double
};

/// Calls find(begin, end, segments), which appends to `segments`, for the elements `begin` to `end` - 1 of
/// each cluster that may hold a silhouette, in parallel.
/// @return what was found, in the order of elements
template <class Find>
std::vector<ContourSegment> searchSilhouettes(const NormalClusters& clusters, std::size_t elements,
  const Eye& eye, SilhouetteSearch search, const Find& find)
{
  std::vector<std::uint32_t> candidates;
  if (search == SilhouetteSearch::Hierarchy)
  {
    candidates = clusters.straddling(eye);
  }
  else
  {
    candidates.resize(clusters.size());
    std::iota(candidates.begin(), candidates.end(), 0u);
  }
  constexpr std::size_t chunkSize = 256;
  std::vector<std::vector<ContourSegment>> found((candidates.size() + chunkSize - 1) / chunkSize);
  parallelFor(found.size(),
    [&](std::size_t chunk)
    {
      const std::size_t end = std::min((chunk + 1) * chunkSize, candidates.size());
      for (std::size_t i = chunk * chunkSize; i < end; ++i)
      {
        const std::size_t first = candidates[i] * NormalClusters::clusterSize;
        find(first, std::min(first + NormalClusters::clusterSize, elements), found[chunk]);
      }
    });
  if (found.size() == 1)
  {
    return std::move(found.front());
  }
  std::vector<ContourSegment> segments;
  for (const std::vector<ContourSegment>& part : found)
  {
    segments.insert(segments.end(), part.begin(), part.end());
  }
  return segments;
}

} // namespace ink
