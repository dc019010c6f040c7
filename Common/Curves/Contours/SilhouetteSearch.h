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

/// Which elements are looked at for an eye. The result is the same.
enum class SilhouetteSearch
{
  Hierarchy, ///< those of clusters that may hold a silhouette
  Exhaustive
};

/// Calls find(element, segments), which appends to `segments`, for elements in clusters that may hold a
/// silhouette, in parallel.
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
        for (std::size_t e = first; e < std::min(first + NormalClusters::clusterSize, elements); ++e)
        {
          find(e, found[chunk]);
        }
      }
    });
  std::vector<ContourSegment> segments;
  for (const std::vector<ContourSegment>& part : found)
  {
    segments.insert(segments.end(), part.begin(), part.end());
  }
  return segments;
}

} // namespace ink
