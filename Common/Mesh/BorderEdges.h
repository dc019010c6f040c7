// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Hash.h"
#include "Mesh/TriangleMesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ink
{

/// The two points of an edge, the lower one first.
using MeshEdge = std::array<std::uint32_t, 2>;

/// The edges of one triangle only, ascending.
/// @param wanted(triangle) whether a triangle counts
template <class Wanted>
std::vector<MeshEdge> borderEdges(const TriangleMesh& mesh, const Wanted& wanted)
{
  std::vector<MeshEdge> edges;
  for (const Triangle& triangle : mesh.triangles)
  {
    for (std::size_t i = 0; i < 3 && wanted(triangle); ++i)
    {
      const auto [low, high] = std::minmax(triangle[i], triangle[(i + 1) % 3]);
      edges.push_back({ low, high });
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<MeshEdge> borders;
  for (std::size_t i = 0; i < edges.size();)
  {
    const std::size_t begin = i;
    while (i < edges.size() && edges[i] == edges[begin])
    {
      ++i;
    }
    if (i == begin + 1 && edges[begin][0] != edges[begin][1])
    {
      borders.push_back(edges[begin]);
    }
  }
  return borders;
}

/// Whether every edge belongs to an even number of triangles, so that there is no border. Much sooner known
/// than the borders: hashes of pairs cancel each other out. Wrong once in 2^64 meshes.
inline bool hasPairedEdges(const TriangleMesh& mesh)
{
  std::uint64_t unpaired = 0;
  for (const Triangle& triangle : mesh.triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto [low, high] = std::minmax(triangle[i], triangle[(i + 1) % 3]);
      unpaired ^= hash(std::uint64_t{ low } << 32 | high);
    }
  }
  return unpaired == 0;
}

} // namespace ink
