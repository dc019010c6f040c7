// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Streamlines/StreamlineTracer.h"

#include "Curves/Streamlines/StreamlineCell.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace ink
{

namespace
{

/// Barycentric coordinates this close to 0 or 1 are 0 or 1.
constexpr double weightTolerance = 1e-9;
/// No half line has more points.
constexpr int mostSteps = 2'000'000;

} // namespace

/// A line on its way.
struct StreamlineTracer::Walk
{
  const StreamlineTracer& tracer;
  MeshPoint at;
  StreamlineCell cell;
  /// The corner opposite the edge that the line came in by; an edge that leads back there is followed.
  int entry = -1;

  Walk(const StreamlineTracer& owner, const MeshPoint& seed, const glm::dvec3& heading)
    : tracer(owner)
    , at(seed)
    , cell(owner.Mesh, owner.Field, seed.triangle, heading)
  {
  }

  /// The corner whose opposite edge the point is on while the direction leads out by it; -1 if none.
  int cornerBehind(const glm::dvec2& direction) const
  {
    const glm::dvec3 rates = this->cell.chart.rates(direction.x, direction.y);
    const double largest = std::max({ std::abs(rates.x), std::abs(rates.y), std::abs(rates.z) });
    for (int corner = 0; corner < 3; ++corner)
    {
      if (this->at.weights[corner] <= 0.0 && rates[corner] < -weightTolerance * largest)
      {
        return corner;
      }
    }
    return -1;
  }

  /// The share of a step to new coordinates after which it leaves the triangle, and the corner opposite the
  /// edge that it leaves by; -1 if it stays inside.
  std::pair<double, int> exit(const glm::dvec3& next) const
  {
    std::pair<double, int> first(1.0, -1);
    for (int corner = 0; corner < 3; ++corner)
    {
      const double weight = this->at.weights[corner];
      if (next[corner] < -1e-12 && weight < first.first * (weight - next[corner]))
      {
        first = { weight / (weight - next[corner]), corner };
      }
    }
    return first;
  }

  /// Takes a step inside the triangle, or up to an edge of it.
  /// @return the corner opposite the edge; -1 if still inside
  int step(const glm::dvec2& direction, double length)
  {
    glm::dvec3 next = this->cell.moved(this->at.weights, length * direction);
    auto [share, corner] = this->exit(next);
    if (this->tracer.Options.integrator == StreamlineIntegrator::RungeKutta4)
    {
      const auto curve = [&](double size) {
        return this->cell.moved(this->at.weights, this->cell.rungeKutta(this->at.weights, direction, size));
      };
      glm::dvec3 curved = curve(length);
      auto [curvedShare, curvedCorner] = this->exit(curved);
      // The length after which the curve meets the edge, by secants. A curve that turns back to the edge that
      // it starts from leaves no share; then the straight step stands.
      for (int n = 0; n < 3 && curvedCorner >= 0 && curvedShare > 1e-6 && curvedShare < 1.0 - 1e-9; ++n)
      {
        length *= curvedShare;
        curved = curve(length);
        const double weight = this->at.weights[curvedCorner];
        curvedShare = weight / std::max(weight - curved[curvedCorner], 1e-300);
        if (std::abs(curvedShare - 1.0) > 0.5)
        {
          break;
        }
      }
      if (curvedCorner < 0 || (std::abs(curvedShare - 1.0) < 0.01 && curvedShare > 1e-6))
      {
        next = curved;
        share = curvedShare;
        corner = curvedCorner;
      }
    }
    if (corner >= 0)
    {
      next = this->at.weights + share * (next - this->at.weights);
      next[corner] = 0.0;
    }
    next = glm::max(next, 0.0);
    this->at.weights = next / (next.x + next.y + next.z);
    return corner;
  }

  /// Moves along the edge opposite a corner.
  /// @return false if the direction is at right angles to it
  bool slide(int corner, const glm::dvec2& direction, double length)
  {
    const glm::dvec2 places[3] = { { 0.0, 0.0 }, { this->cell.chart.length, 0.0 },
      { this->cell.chart.x2, this->cell.chart.y2 } };
    const int from = (corner + 1) % 3;
    const int to = (corner + 2) % 3;
    const glm::dvec2 edge = places[to] - places[from];
    const double size = glm::length(edge);
    const double along = glm::dot(direction, edge) / size;
    if (std::abs(along) < 1e-3)
    {
      return false;
    }
    const int target = along > 0.0 ? to : from;
    this->at.weights[corner] = 0.0;
    this->at.weights[target] = std::min(this->at.weights[target] + length / size, 1.0);
    this->at.weights[along > 0.0 ? from : to] = 1.0 - this->at.weights[target];
    return true;
  }

  /// Goes on in the triangle around a corner that the direction points into.
  std::optional<LineEnd> leaveVertex(int corner, const glm::dvec3& heading)
  {
    struct Choice
    {
      std::uint32_t triangle;
      int corner;
      double score = -2.0;
      int behind = -1;
      bool onwards = false;
    } best{ this->at.triangle, corner };
    const auto consider = [&](std::uint32_t triangle, int c)
    {
      const TriangleChart chart = this->tracer.Mesh.chart(triangle);
      const glm::dvec2 places[3] = { { 0.0, 0.0 }, { chart.length, 0.0 }, { chart.x2, chart.y2 } };
      const glm::dvec2 v =
        glm::normalize(glm::dvec2(glm::dot(heading, chart.axisX), glm::dot(heading, chart.axisY)));
      const glm::dvec2 right = glm::normalize(places[(c + 1) % 3] - places[c]);
      const glm::dvec2 left = glm::normalize(places[(c + 2) % 3] - places[c]);
      const double fromRight = right.x * v.y - right.y * v.x;
      const double fromLeft = v.x * left.y - v.y * left.x;
      const double score = std::min(fromRight, fromLeft);
      if (score > best.score)
      {
        const bool isRight = fromRight < fromLeft;
        best = { triangle, c, score, (c + (isRight ? 2 : 1)) % 3, glm::dot(v, isRight ? right : left) > 0.0 };
      }
    };
    consider(this->at.triangle, corner);
    bool isOpen = false;
    for (int side = 0; side < 2; ++side)
    {
      std::uint32_t triangle = this->at.triangle;
      auto c = static_cast<std::uint32_t>(corner);
      // Edge c runs from the corner, edge c + 2 to it.
      std::uint32_t edge = side == 0 ? (c + 2) % 3 : c;
      std::optional<MeshNavigation::Neighbor> next;
      while ((next = this->tracer.Mesh.across(triangle, edge)) && next->triangle != this->at.triangle)
      {
        c = next->corner(edge == c ? 0 : 1);
        triangle = next->triangle;
        edge = next->edge == c ? (c + 2) % 3 : c;
        consider(triangle, static_cast<int>(c));
      }
      if (next)
      {
        break; // once around
      }
      isOpen = true;
    }
    const bool isInside = best.score > -weightTolerance;
    if (!isInside && (isOpen || !best.onwards))
    {
      return isOpen ? LineEnd::Border : LineEnd::Umbilic;
    }
    this->at.triangle = best.triangle;
    this->at.weights = glm::dvec3(0.0);
    this->at.weights[best.corner] = 1.0;
    this->cell = StreamlineCell(this->tracer.Mesh, this->tracer.Field, best.triangle, heading);
    this->entry = isInside ? -1 : best.behind;
    return std::nullopt;
  }

  /// Goes on behind the edge opposite a corner.
  std::optional<LineEnd> leaveByEdge(int corner, const glm::dvec2& direction)
  {
    glm::dvec3 heading = this->cell.lift(direction);
    const auto edge = static_cast<std::uint32_t>(corner + 1) % 3;
    const auto next = this->tracer.Mesh.across(this->at.triangle, edge);
    if (!next || !this->tracer.Mesh.cross(this->at, edge, heading))
    {
      return LineEnd::Border;
    }
    this->entry = static_cast<int>((next->edge + 2) % 3);
    this->cell = StreamlineCell(this->tracer.Mesh, this->tracer.Field, this->at.triangle, heading);
    return std::nullopt;
  }

  int vertex() const
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      if (this->at.weights[corner] > 1.0 - weightTolerance)
      {
        return corner;
      }
    }
    return -1;
  }
};

StreamlineTracer::StreamlineTracer(
  const MeshNavigation& mesh, const LineField& field, const TraceOptions& options)
  : Mesh(mesh)
  , Field(field)
  , Options(options)
{
}

glm::dvec3 StreamlineTracer::direction(const MeshPoint& point, const glm::dvec3& heading) const
{
  const StreamlineCell cell(this->Mesh, this->Field, point.triangle, heading);
  return cell.lift(cell.direction(point.weights));
}

LineEnd StreamlineTracer::follow(
  const MeshPoint& seed, const glm::dvec3& heading, double length, const Accept& accept) const
{
  if (!this->Mesh.isUsable(seed.triangle))
  {
    return LineEnd::Border;
  }
  Walk walk(*this, seed, heading);
  TracedPoint last{ seed, walk.cell.chart.position(seed.weights), 0.0 };
  double arc = 0.0;
  glm::dvec3 position = last.position;
  // Crossings without progress, as around a vertex, must not go on forever.
  int crossings = 0;
  for (int n = 0; n < mostSteps; ++n)
  {
    if (walk.cell.isSingular && this->Options.stopAtSingularities)
    {
      return LineEnd::Umbilic;
    }
    if (this->Options.umbilicLimit < 1.0 && !this->Field.umbilics.empty())
    {
      const auto& [a, b, c] = this->Mesh.mesh().triangles[walk.at.triangle];
      const glm::dvec3 corners(this->Field.umbilics[a], this->Field.umbilics[b], this->Field.umbilics[c]);
      if (!(glm::dot(corners, walk.at.weights) <= this->Options.umbilicLimit))
      {
        return LineEnd::Umbilic;
      }
    }
    const glm::dvec2 direction = walk.cell.direction(walk.at.weights);
    if (direction == glm::dvec2(0.0))
    {
      return LineEnd::Umbilic;
    }
    const double left = length - arc;
    const double step =
      std::min({ this->Options.stepFactor * walk.cell.adaptiveStep, this->Options.maximumStep, left });
    int exit = walk.cornerBehind(direction);
    if (exit < 0 || exit == walk.entry)
    {
      if (exit >= 0)
      {
        if (!walk.slide(exit, direction, step))
        {
          return LineEnd::Umbilic;
        }
        exit = -1;
      }
      else
      {
        exit = walk.step(direction, step);
        walk.entry = -1;
      }
      const glm::dvec3 next = walk.cell.chart.position(walk.at.weights);
      const double advance = glm::distance(next, position);
      arc += advance;
      position = next;
      crossings = advance > 1e-6 * walk.cell.adaptiveStep ? 0 : crossings + 1;
      // What is hardly a step is no point of its own.
      if (arc - last.arc > 1e-3 * step || arc >= length)
      {
        last = { walk.at, position, arc };
        if (!accept(last))
        {
          return LineEnd::Stopped;
        }
      }
      if (arc >= length * (1.0 - 1e-12))
      {
        return LineEnd::Length;
      }
    }
    else
    {
      ++crossings;
    }
    if (crossings > 1000)
    {
      return LineEnd::Umbilic;
    }
    std::optional<LineEnd> end;
    if (const int vertex = walk.vertex(); vertex >= 0)
    {
      const std::uint32_t point =
        this->Mesh.mesh().triangles[walk.at.triangle][static_cast<std::size_t>(vertex)];
      const glm::dvec3 own = this->Field.along(point, walk.cell.lift(direction));
      end = walk.leaveVertex(vertex, own == glm::dvec3(0.0) ? walk.cell.lift(direction) : own);
    }
    else if (exit >= 0)
    {
      const glm::dvec2 here = walk.cell.direction(walk.at.weights);
      end = walk.leaveByEdge(exit, here == glm::dvec2(0.0) ? direction : here);
    }
    if (end)
    {
      return *end;
    }
  }
  return LineEnd::Length;
}

TracedLine StreamlineTracer::trace(
  const MeshPoint& seed, const glm::dvec3& heading, const Accept& accept) const
{
  TracedLine line;
  if (!this->Mesh.isUsable(seed.triangle))
  {
    return line;
  }
  const glm::dvec3 start = this->Mesh.position(seed);
  const glm::dvec3 forward = this->direction(seed, heading);
  if (forward == glm::dvec3(0.0))
  {
    line.ends = { LineEnd::Umbilic, LineEnd::Umbilic };
    return line;
  }
  const double near = this->Options.closeDistance;
  std::vector<TracedPoint> halves[2];
  glm::dvec3 before;
  double lastArc = 0.0;
  const auto isBack = [&](const TracedPoint& point)
  {
    // The segment from the point before passes the plane through the start at right angles to the line.
    const glm::dvec3 segment = point.position - before;
    const double from = glm::dot(start - before, forward);
    const double to = glm::dot(point.position - start, forward);
    if (lastArc == 0.0 || point.arc < 4.0 * near || from < 0.0 || to < 0.0 ||
      !(from + to > 0.5 * glm::length(segment)))
    {
      return false;
    }
    return glm::distance(before + from / (from + to) * segment, start) < near;
  };
  for (int half = 0; half < 2; ++half)
  {
    before = start;
    lastArc = 0.0;
    line.ends[static_cast<std::size_t>(half)] =
      this->follow(seed, half == 0 ? forward : -forward, 0.5 * this->Options.maximumLength,
        [&](const TracedPoint& point)
        {
          if (half == 0 && near > 0.0 && isBack(point))
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
  for (const TracedPoint& point : halves[0])
  {
    line.points.push_back({ point.at, point.position, behind + point.arc });
  }
  return line;
}

} // namespace ink
