// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Contours/ContourSegments.h"
#include "Curves/Contours/ContourSurface.h"

#include <cstdint>
#include <vector>

namespace ink
{

/// An edge at a hole of a surface, which is known by the same number all around.
struct HoleEdge
{
  ContourSegment edge; ///< its nodes lie at sites
  std::uint32_t hole;
};

/// The holes of a surface that are not to be seen, and so must not interrupt its silhouettes either.
class SurfaceHoles
{
public:
  explicit SurfaceHoles(const std::vector<HoleEdge>& edges);

  /// Appends a segment straight across each hole where one silhouette enters it and one leaves it. Where more
  /// do, nobody knows which belong together, and they end.
  /// @param segments of interpolated silhouettes, which meet borders between two corners
  void bridge(const ContourSurface& surface, std::vector<ContourSegment>& segments) const;

private:
  struct Edge
  {
    std::uint64_t sites;
    std::uint32_t hole;
    auto operator<=>(const Edge&) const = default;
  };
  std::vector<Edge> Edges; ///< ascending
};

} // namespace ink
