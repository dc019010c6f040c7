// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace ink
{

/// Why half of a line ended.
enum class LineEnd : std::uint8_t
{
  Border,  ///< of the surface, or at an edge that cannot be crossed
  Umbilic, ///< the direction is not defined
  Length,  ///< the greatest length is reached
  Closed,  ///< it is back at its start
  Stopped, ///< whoever asked for it stopped it
};

/// A point of a line on a surface.
/// @tparam Point a position on it as the surface knows it: MeshPoint, FieldPoint
template <class Point>
struct TracedPointOn
{
  Point at;
  glm::dvec3 position;
  double arc; ///< from the line's first point, in world units
};

template <class Point>
struct TracedLineOn
{
  std::vector<TracedPointOn<Point>> points;
  std::size_t seed = 0;          ///< the point that it started at
  bool closed = false;           ///< then the last point is joined to the first
  std::array<LineEnd, 2> ends{}; ///< of the half along the seed's direction, and of the other one
};

/// Of each point after the seed, in order: whether to go on; false leaves the point out. `arc` is from the
/// seed.
template <class Point>
using AcceptPoint = std::function<bool(const TracedPointOn<Point>&)>;

/// Traces a line from its seed, first along a direction and then, unless it is closed, against it; there
/// `arc` is negative for `accept`, which may be empty.
/// @param forward the unit direction at the seed
/// @param closeDistance a line that passes its start in this distance is closed; 0: none is
/// @param follow LineEnd(heading, accept): traces a half
template <class Point, class Follow>
TracedLineOn<Point> traceHalves(const Point& seed, const glm::dvec3& start, const glm::dvec3& forward,
  double closeDistance, const AcceptPoint<Point>& accept, const Follow& follow)
{
  TracedLineOn<Point> line;
  std::vector<TracedPointOn<Point>> halves[2];
  glm::dvec3 before;
  double lastArc = 0.0;
  const auto isBack = [&](const TracedPointOn<Point>& point)
  {
    // The segment from the point before passes the plane through the start at right angles to the line.
    const glm::dvec3 segment = point.position - before;
    const double from = glm::dot(start - before, forward);
    const double to = glm::dot(point.position - start, forward);
    if (lastArc == 0.0 || point.arc < 4.0 * closeDistance || from < 0.0 || to < 0.0 ||
      !(from + to > 0.5 * glm::length(segment)))
    {
      return false;
    }
    return glm::distance(before + from / (from + to) * segment, start) < closeDistance;
  };
  for (std::size_t half = 0; half < 2; ++half)
  {
    before = start;
    lastArc = 0.0;
    line.ends[half] = follow(half == 0 ? forward : -forward,
      [&](const TracedPointOn<Point>& point)
      {
        if (half == 0 && closeDistance > 0.0 && isBack(point))
        {
          line.closed = true;
          return false;
        }
        if (accept && !accept({ point.at, point.position, half == 0 ? point.arc : -point.arc }))
        {
          return false;
        }
        before = point.position;
        lastArc = point.arc;
        halves[half].push_back(point);
        return true;
      });
    if (line.closed)
    {
      line.ends = { LineEnd::Closed, LineEnd::Closed };
      break;
    }
  }
  line.seed = halves[1].size();
  const double behind = halves[1].empty() ? 0.0 : halves[1].back().arc;
  line.points.reserve(halves[0].size() + halves[1].size() + 1);
  for (auto point = halves[1].rbegin(); point != halves[1].rend(); ++point)
  {
    line.points.push_back({ point->at, point->position, behind - point->arc });
  }
  line.points.push_back({ seed, start, behind });
  for (const TracedPointOn<Point>& point : halves[0])
  {
    line.points.push_back({ point.at, point.position, behind + point.arc });
  }
  return line;
}

} // namespace ink
