// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Streamlines/MeshWalk.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace ink
{

namespace
{

/// Barycentric coordinates this close to 0 or 1 are 0 or 1.
constexpr double weightTolerance = 1e-9;

} // namespace

MeshWalk::MeshWalk(const MeshNavigation& mesh, const LineField& field, bool curves, const MeshPoint& seed,
  const glm::dvec3& heading)
  : Mesh(mesh)
  , Field(field)
  , Curves(curves)
  , At(seed)
  , Cell(mesh, field, seed.triangle, heading)
{
}

int MeshWalk::cornerBehind(const glm::dvec2& direction) const
{
  const glm::dvec3 rates = this->Cell.chart.rates(direction.x, direction.y);
  const double largest = std::max({ std::abs(rates.x), std::abs(rates.y), std::abs(rates.z) });
  for (int corner = 0; corner < 3; ++corner)
  {
    if (this->At.weights[corner] <= 0.0 && rates[corner] < -weightTolerance * largest)
    {
      return corner;
    }
  }
  return -1;
}

std::pair<double, int> MeshWalk::exit(const glm::dvec3& next) const
{
  std::pair<double, int> first(1.0, -1);
  for (int corner = 0; corner < 3; ++corner)
  {
    const double weight = this->At.weights[corner];
    if (next[corner] < -1e-12 && weight < first.first * (weight - next[corner]))
    {
      first = { weight / (weight - next[corner]), corner };
    }
  }
  return first;
}

int MeshWalk::step(const glm::dvec2& direction, double length)
{
  this->Entry = -1;
  glm::dvec3 next = this->Cell.moved(this->At.weights, length * direction);
  auto [share, corner] = this->exit(next);
  if (this->Curves)
  {
    const auto curve = [&](double size)
    { return this->Cell.moved(this->At.weights, this->Cell.rungeKutta(this->At.weights, direction, size)); };
    glm::dvec3 curved = curve(length);
    auto [curvedShare, curvedCorner] = this->exit(curved);
    // The length after which the curve meets the edge, by secants. A curve that turns back to the edge that
    // it starts from leaves no share; then the straight step stands.
    for (int n = 0; n < 3 && curvedCorner >= 0 && curvedShare > 1e-6 && curvedShare < 1.0 - 1e-9; ++n)
    {
      length *= curvedShare;
      curved = curve(length);
      const double weight = this->At.weights[curvedCorner];
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
    next = this->At.weights + share * (next - this->At.weights);
    next[corner] = 0.0;
  }
  next = glm::max(next, 0.0);
  this->At.weights = next / (next.x + next.y + next.z);
  return corner;
}

bool MeshWalk::slide(int corner, const glm::dvec2& direction, double length)
{
  const int from = (corner + 1) % 3;
  const int to = (corner + 2) % 3;
  const TriangleChart& chart = this->Cell.chart;
  const glm::dvec2 edge =
    chart.corner(static_cast<std::uint32_t>(to)) - chart.corner(static_cast<std::uint32_t>(from));
  const double size = glm::length(edge);
  const double along = glm::dot(direction, edge) / size;
  if (std::abs(along) < 1e-3)
  {
    return false;
  }
  const int target = along > 0.0 ? to : from;
  this->At.weights[corner] = 0.0;
  this->At.weights[target] = std::min(this->At.weights[target] + length / size, 1.0);
  this->At.weights[along > 0.0 ? from : to] = 1.0 - this->At.weights[target];
  return true;
}

std::optional<LineEnd> MeshWalk::leaveVertex(int corner, const glm::dvec3& heading)
{
  struct Choice
  {
    std::uint32_t triangle;
    int corner;
    double score = -2.0;
    int behind = -1;
    bool onwards = false;
  } best{ this->At.triangle, corner };
  const auto consider = [&](std::uint32_t triangle, int c)
  {
    const TriangleChart chart = this->Mesh.chart(triangle);
    const glm::dvec2 corners[3] = { { 0.0, 0.0 }, { chart.length, 0.0 }, { chart.x2, chart.y2 } };
    const glm::dvec2 v =
      glm::normalize(glm::dvec2(glm::dot(heading, chart.axisX), glm::dot(heading, chart.axisY)));
    const glm::dvec2 right = glm::normalize(corners[(c + 1) % 3] - corners[c]);
    const glm::dvec2 left = glm::normalize(corners[(c + 2) % 3] - corners[c]);
    const double fromRight = right.x * v.y - right.y * v.x;
    const double fromLeft = v.x * left.y - v.y * left.x;
    const double score = std::min(fromRight, fromLeft);
    if (score > best.score)
    {
      const bool isRight = fromRight < fromLeft;
      best = { triangle, c, score, (c + (isRight ? 2 : 1)) % 3, glm::dot(v, isRight ? right : left) > 0.0 };
    }
  };
  consider(this->At.triangle, corner);
  bool isOpen = false;
  for (int side = 0; side < 2; ++side)
  {
    std::uint32_t triangle = this->At.triangle;
    auto c = static_cast<std::uint32_t>(corner);
    // Edge c runs from the corner, edge c + 2 to it.
    std::uint32_t edge = side == 0 ? (c + 2) % 3 : c;
    std::optional<MeshNavigation::Neighbor> next;
    while ((next = this->Mesh.across(triangle, edge)) && next->triangle != this->At.triangle)
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
  this->At.triangle = best.triangle;
  this->At.weights = glm::dvec3(0.0);
  this->At.weights[best.corner] = 1.0;
  this->Cell = StreamlineCell(this->Mesh, this->Field, best.triangle, heading);
  this->Entry = isInside ? -1 : best.behind;
  return std::nullopt;
}

std::optional<LineEnd> MeshWalk::leaveByEdge(int corner, const glm::dvec2& direction)
{
  const auto edge = static_cast<std::uint32_t>(corner + 1) % 3;
  const auto next = this->Mesh.across(this->At.triangle, edge);
  TriangleChart chart = this->Cell.chart;
  glm::dvec2 heading = direction;
  if (!next || !this->Mesh.cross(this->At, chart, edge, heading))
  {
    return LineEnd::Border;
  }
  this->Entry = static_cast<int>((next->edge + 2) % 3);
  this->Cell = StreamlineCell(
    this->Mesh, this->Field, this->At.triangle, chart, heading.x * chart.axisX + heading.y * chart.axisY);
  return std::nullopt;
}

int MeshWalk::vertex() const
{
  for (int corner = 0; corner < 3; ++corner)
  {
    if (this->At.weights[corner] > 1.0 - weightTolerance)
    {
      return corner;
    }
  }
  return -1;
}

} // namespace ink
