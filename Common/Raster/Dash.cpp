// SPDX-License-Identifier: BSD-3-Clause
#include "Raster/Dash.h"

#include "Core/ParallelFor.h"
#include "Raster/RowScan.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace ink::raster
{

namespace
{

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// A point of a line and the fraction of its ink that remains.
struct DashPoint
{
  glm::ivec2 pixel;
  float share;
};

/// The coverage by dashes of the pixel around a position along a line.
float coverageByDashes(double along, double dash, double period)
{
  const auto dashesUpTo = [&](double end)
  {
    const double periods = std::floor(end / period);
    return periods * dash + std::min(end - periods * period, dash);
  };
  return static_cast<float>(std::clamp(dashesUpTo(along + 0.5) - dashesUpTo(along - 0.5), 0.0, 1.0));
}

std::vector<DashPoint> dashPoints(std::span<const TracedLine> lines, float dash, float gap)
{
  std::vector<DashPoint> points;
  for (const TracedLine& line : lines)
  {
    const std::vector<float> lengths = lengthsAlong(line);
    const float length = lengths.empty() ? 0.0f : lengths.back();
    const bool isClosed = line.size() > 2 && line.front() == line.back();
    // An open line has one gap fewer than dashes.
    const float count = std::max(1.0f, std::round((length + (isClosed ? 0.0f : gap)) / (dash + gap)));
    const float planned = count * (dash + gap) - (isClosed ? 0.0f : gap);
    const float scale = length > 0.0f ? length / planned : 1.0f;
    const bool isWhole = !isClosed && count < 2.0f;
    for (std::size_t i = 0; i < line.size(); ++i)
    {
      const bool isEnd = !isClosed && (i == 0 || i + 1 == line.size());
      points.push_back({ line[i],
        isWhole || isEnd ? 1.0f : coverageByDashes(lengths[i], scale * dash, scale * (dash + gap)) });
    }
  }
  return points;
}

/// The nearest point to each pixel of ink: propagates from the points through the ink, a ring of pixels at a
/// time, each pixel taking the nearest of its neighbors' points.
std::vector<std::uint32_t> nearestDashPoints(const CoverageImage& image, std::span<const DashPoint> points)
{
  const auto indexOf = [&](glm::ivec2 p)
  {
    return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(image.width) +
      static_cast<std::size_t>(p.x);
  };
  std::vector<std::uint32_t> nearest(image.pixels.size(), none);
  std::vector<glm::ivec2> ring;
  for (std::uint32_t i = 0; i < points.size(); ++i)
  {
    const glm::ivec2 p = points[i].pixel;
    if (p.x < 0 || p.y < 0 || p.x >= image.width || p.y >= image.height)
    {
      throw std::invalid_argument("a line to be dashed leaves the picture");
    }
    std::uint32_t& here = nearest[indexOf(p)];
    if (here == none)
    {
      here = i;
      ring.push_back(p);
    }
    else if (points[i].share > points[here].share) // where lines meet
    {
      here = i;
    }
  }
  std::vector<glm::ivec2> next;
  while (!ring.empty())
  {
    next.clear();
    for (const glm::ivec2 from : ring)
    {
      const std::uint32_t point = nearest[indexOf(from)];
      for (int y = std::max(from.y - 1, 0); y <= std::min(from.y + 1, image.height - 1); ++y)
      {
        for (int x = std::max(from.x - 1, 0); x <= std::min(from.x + 1, image.width - 1); ++x)
        {
          const glm::ivec2 to(x, y);
          std::uint32_t& there = nearest[indexOf(to)];
          if (image.row(y)[x] == 0 || there == point)
          {
            continue;
          }
          const auto squared = [&](std::uint32_t p)
          {
            const glm::ivec2 way = points[p].pixel - to;
            return way.x * way.x + way.y * way.y;
          };
          if (there == none || std::pair(squared(point), point) < std::pair(squared(there), there))
          {
            there = point;
            next.push_back(to);
          }
        }
      }
    }
    std::swap(ring, next);
  }
  return nearest;
}

} // namespace

void dash(const CoverageImage& image, std::span<const TracedLine> lines, float dash, float gap)
{
  image.check();
  if (!(dash > 0.0f) || !(gap > 0.0f) || !std::isfinite(dash + gap))
  {
    return;
  }
  const std::vector<DashPoint> points = dashPoints(lines, dash, gap);
  const std::vector<std::uint32_t> nearest = nearestDashPoints(image, points);
  parallelFor(static_cast<std::size_t>(image.height),
    [&](std::size_t y)
    {
      unsigned char* const row = image.row(static_cast<int>(y));
      const std::uint32_t* const nearestOfRow = nearest.data() + y * static_cast<std::size_t>(image.width);
      for (int x = skipEmpty(row, 0, image.width); x < image.width; x = skipEmpty(row, x + 1, image.width))
      {
        if (nearestOfRow[x] != none)
        {
          row[x] = static_cast<unsigned char>(
            std::lround(points[nearestOfRow[x]].share * static_cast<float>(row[x])));
        }
      }
    });
}

} // namespace ink::raster
