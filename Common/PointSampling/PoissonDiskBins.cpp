// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/PoissonDiskBins.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>
#include <string>

namespace ink
{

namespace
{

// Relative to the radius: a triangle with a longer edge is divided into squares with this side.
constexpr float longestEdge = 3.2f;
constexpr float side = 1.0f;

} // namespace

PoissonDiskBins::PoissonDiskBins(
  std::span<const glm::vec3> points, std::span<const Triangle> triangles, std::span<const float> radii)
  : Radii(radii)
  , Unfolding(points, triangles)
  , Discs(std::size_t(1) << (32 - discBits))
{
  std::uint64_t bins = 0;
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
  {
    const float radius = radii.empty() ? 1.0f : radii[t];
    GeodesicUnfolding::Facet& facet = this->Unfolding.facets()[t];
    const auto& [corners, normal, across, tag] = facet;
    facet.tag = nothing;
    if (!(radius > 0.0f) || normal == glm::vec3(0.0f))
    {
      continue;
    }
    std::uint32_t longest = 0;
    float most = 0.0f;
    for (std::uint32_t e = 0; e < 3; ++e)
    {
      const glm::vec3 edge = corners[e == 2 ? 0u : e + 1] - corners[e];
      if (const float square = glm::dot(edge, edge); square > most)
      {
        most = square;
        longest = e;
      }
    }
    if (most <= longestEdge * longestEdge * radius * radius)
    {
      const bool tiny = most <= smallest * smallest * radius * radius;
      facet.tag = static_cast<std::uint32_t>(bins++) | (tiny ? isSmall : 0u);
    }
    else
    {
      Grid grid;
      const float length = std::sqrt(most);
      grid.origin = corners[longest];
      grid.right = (corners[(longest + 1) % 3] - grid.origin) / length;
      grid.up = glm::cross(normal, grid.right);
      grid.cell = side * radius;
      const float height = glm::dot(corners[(longest + 2) % 3] - grid.origin, grid.up);
      const double columns = std::max(std::ceil(static_cast<double>(length) / grid.cell), 1.0);
      const double rows = std::max(std::ceil(static_cast<double>(height) / grid.cell), 1.0);
      grid.firstBin = static_cast<std::uint32_t>(bins);
      if (static_cast<double>(bins) + columns * rows < static_cast<double>(isSmall))
      {
        grid.columns = static_cast<std::uint32_t>(columns);
        grid.rows = static_cast<std::uint32_t>(rows);
      }
      bins += static_cast<std::uint64_t>(std::min(columns * rows, static_cast<double>(isSmall)));
      facet.tag = static_cast<std::uint32_t>(this->Grids.size()) | isGrid;
      this->Grids.push_back(grid);
    }
    if (bins >= isSmall)
    {
      throw std::invalid_argument("the mesh is too large for the radius: it has room for more than " +
        std::to_string(isSmall / 3) + " samples; expected a larger radius or fewer samples");
    }
  }
  this->Heads.assign(bins, nothing);
}

std::uint32_t PoissonDiskBins::binAt(std::uint32_t tag, const glm::vec3& position) const
{
  if (!(tag & isGrid))
  {
    return tag & ~isSmall;
  }
  const Grid& grid = this->Grids[tag & ~isGrid];
  const glm::vec3 offset = position - grid.origin;
  const auto index = [&](const glm::vec3& axis, std::uint32_t count)
  {
    const auto exact = static_cast<std::int32_t>(glm::dot(offset, axis) / grid.cell);
    return static_cast<std::uint32_t>(std::clamp(exact, 0, static_cast<std::int32_t>(count - 1)));
  };
  return grid.firstBin + index(grid.up, grid.rows) * grid.columns + index(grid.right, grid.columns);
}

bool PoissonDiskBins::isTaken(std::uint32_t triangle, const glm::vec3& position, float radius) const
{
  const std::uint32_t head = this->Heads[this->binAt(this->tagOf(triangle), position)];
  if (head == covered)
  {
    return true;
  }
  for (std::uint32_t id = head; id != nothing;)
  {
    const Disc& near = this->disc(id);
    const glm::vec3 offset = position - near.center;
    const float limit = std::min(radius, near.radius);
    if (glm::dot(offset, offset) < limit * limit)
    {
      return true;
    }
    id = near.next;
  }
  return false;
}

void PoissonDiskBins::addTo(std::uint32_t bin, const glm::vec3& center, float radius, Workspace& workspace)
{
  std::uint32_t id = workspace.FreeDiscs;
  if (id != nothing)
  {
    workspace.FreeDiscs = this->disc(id).next;
  }
  else
  {
    if (workspace.NextDisc == workspace.EndOfDiscs)
    {
      const std::lock_guard<std::mutex> guard(this->Lock);
      if (this->DiscBlocks + 1 == this->Discs.size())
      {
        throw std::bad_alloc();
      }
      this->Discs[this->DiscBlocks] = std::make_unique_for_overwrite<Disc[]>(std::size_t(1) << discBits);
      workspace.NextDisc = this->DiscBlocks++ << discBits;
      workspace.EndOfDiscs = workspace.NextDisc + (1u << discBits);
    }
    id = workspace.NextDisc++;
  }
  this->disc(id) = { center, radius, this->Heads[bin] };
  this->Heads[bin] = id;
}

void PoissonDiskBins::cover(std::uint32_t bin, Workspace& workspace)
{
  const std::uint32_t first = this->Heads[bin];
  this->Heads[bin] = covered;
  if (first == nothing)
  {
    return;
  }
  std::uint32_t last = first;
  while (this->disc(last).next != nothing)
  {
    last = this->disc(last).next;
  }
  this->disc(last).next = workspace.FreeDiscs;
  workspace.FreeDiscs = first;
}

void PoissonDiskBins::add(const GeodesicUnfolding::SurfacePoint& center, float radius, Workspace& workspace)
{
  this->Unfolding.visitAround(center, radius, workspace.Front,
    [&](std::uint32_t triangle, const GeodesicUnfolding::Facet& facet, const glm::vec3& image,
      const float squares[3])
    {
      const std::uint32_t bin = facet.tag;
      if (bin == nothing)
      {
        return;
      }
      // Samples here need no more than their own radius as a distance.
      const float least = this->Radii.empty() ? 1.0f : std::min(radius, this->Radii[triangle]);
      if (bin & isGrid)
      {
        this->addToGrid(this->Grids[bin & ~isGrid], least, image, radius, workspace);
        return;
      }
      if (bin & isSmall)
      {
        const float nearest = std::min({ squares[0], squares[1], squares[2] });
        constexpr float touching = (1.0f + smallest) * (1.0f + smallest);
        if (!(least < radius) || nearest < touching * least * least)
        {
          this->Heads[bin & ~isSmall] = covered;
        }
        return;
      }
      if (this->Heads[bin] == covered)
      {
        return;
      }
      const float limit = least * least;
      if (squares[0] < limit && squares[1] < limit && squares[2] < limit)
      {
        this->cover(bin, workspace);
      }
      else
      {
        this->addTo(bin, image, radius, workspace);
      }
    });
}

void PoissonDiskBins::addToGrid(
  const Grid& grid, float least, const glm::vec3& center, float radius, Workspace& workspace)
{
  const glm::vec3 offset = center - grid.origin;
  const float x = glm::dot(offset, grid.right);
  const float y = glm::dot(offset, grid.up);
  const float above = glm::dot(offset, glm::cross(grid.right, grid.up));
  const float height = above * above;
  const float reach = radius * radius - height;
  if (!(reach > 0.0f))
  {
    return;
  }
  const float wide = std::sqrt(reach);
  const auto range = [&](float coordinate, std::uint32_t count)
  {
    const auto last = static_cast<std::int32_t>(count - 1);
    const auto at = [&](float edge)
    { return std::clamp(static_cast<std::int32_t>(std::floor(edge / grid.cell)), -1, last + 1); };
    return std::pair(std::max(at(coordinate - wide), 0), std::min(at(coordinate + wide), last));
  };
  const auto [left, right] = range(x, grid.columns);
  const auto [bottom, top] = range(y, grid.rows);
  const float limit = least * least - height;
  for (std::int32_t row = bottom; row <= top; ++row)
  {
    const float low = static_cast<float>(row) * grid.cell - y;
    const float high = low + grid.cell;
    const float nearY = std::max({ low, -high, 0.0f });
    const float farY = std::max(-low, high);
    for (std::int32_t column = left; column <= right; ++column)
    {
      const float begin = static_cast<float>(column) * grid.cell - x;
      const float end = begin + grid.cell;
      const float nearX = std::max({ begin, -end, 0.0f });
      const float farX = std::max(-begin, end);
      const std::uint32_t bin =
        grid.firstBin + static_cast<std::uint32_t>(row) * grid.columns + static_cast<std::uint32_t>(column);
      if (this->Heads[bin] == covered || nearX * nearX + nearY * nearY >= reach)
      {
        continue;
      }
      if (farX * farX + farY * farY < limit)
      {
        this->cover(bin, workspace);
      }
      else
      {
        this->addTo(bin, center, radius, workspace);
      }
    }
  }
}

void PoissonDiskBins::listOpen(std::uint32_t triangle, std::vector<Open>& open) const
{
  const std::uint32_t tag = this->tagOf(triangle);
  if (tag == nothing)
  {
    return;
  }
  if (!(tag & isGrid))
  {
    if (this->Heads[tag & ~isSmall] != covered)
    {
      open.push_back({ triangle, tag & ~isSmall });
    }
    return;
  }
  const Grid& grid = this->Grids[tag & ~isGrid];
  for (std::uint32_t bin = grid.firstBin; bin < grid.firstBin + grid.columns * grid.rows; ++bin)
  {
    if (this->Heads[bin] != covered)
    {
      open.push_back({ triangle, bin });
    }
  }
}

void PoissonDiskBins::listDiscs(const Open& bin, std::vector<Disc>& discs) const
{
  discs.clear();
  for (std::uint32_t id = this->Heads[bin.bin]; id != nothing && id != covered; id = this->disc(id).next)
  {
    discs.push_back(this->disc(id));
  }
}

PoissonDiskBins::Outline PoissonDiskBins::outline(const Open& bin) const
{
  Outline result;
  for (const glm::vec3& corner : this->Unfolding.facets()[bin.triangle].corners)
  {
    result.corners[result.count++] = corner;
  }
  result.barycentric = { glm::vec2(0.0f), glm::vec2(1.0f, 0.0f), glm::vec2(0.0f, 1.0f) };
  const std::uint32_t tag = this->tagOf(bin.triangle);
  if (!(tag & isGrid))
  {
    return result;
  }
  const Grid& grid = this->Grids[tag & ~isGrid];
  const std::uint32_t index = bin.bin - grid.firstBin;
  const std::uint32_t column = index % grid.columns;
  const std::uint32_t row = index / grid.columns;
  const float left = static_cast<float>(column) * grid.cell;
  const float bottom = static_cast<float>(row) * grid.cell;
  const auto clip = [&](const glm::vec3& axis, float low, float sign)
  {
    Outline clipped;
    const auto add = [&](const glm::vec3& corner, const glm::vec2& barycentric)
    {
      // Only rounding, in a nearly degenerate triangle, could give more.
      if (clipped.count < static_cast<int>(clipped.corners.size()))
      {
        clipped.corners[clipped.count] = corner;
        clipped.barycentric[clipped.count++] = barycentric;
      }
    };
    for (int i = 0; i < result.count; ++i)
    {
      const int next = (i + 1) % result.count;
      const glm::vec3& a = result.corners[i];
      const glm::vec3& b = result.corners[next];
      const float insideA = sign * (glm::dot(a - grid.origin, axis) - low);
      const float insideB = sign * (glm::dot(b - grid.origin, axis) - low);
      if (insideA >= 0.0f)
      {
        add(a, result.barycentric[i]);
      }
      if ((insideA >= 0.0f) != (insideB >= 0.0f))
      {
        const float share = insideA / (insideA - insideB);
        add(a + share * (b - a),
          result.barycentric[i] + share * (result.barycentric[next] - result.barycentric[i]));
      }
    }
    result = clipped;
  };
  clip(grid.right, left, 1.0f);
  clip(grid.right, left + grid.cell, -1.0f);
  clip(grid.up, bottom, 1.0f);
  clip(grid.up, bottom + grid.cell, -1.0f);
  return result;
}

glm::vec3 PoissonDiskBins::cornerOf(const Open& bin) const
{
  const std::uint32_t tag = this->tagOf(bin.triangle);
  if (!(tag & isGrid))
  {
    return this->Unfolding.facets()[bin.triangle].corners[0];
  }
  const Grid& grid = this->Grids[tag & ~isGrid];
  const std::uint32_t index = bin.bin - grid.firstBin;
  const std::uint32_t column = index % grid.columns;
  const std::uint32_t row = index / grid.columns;
  return grid.origin + static_cast<float>(column) * grid.cell * grid.right +
    static_cast<float>(row) * grid.cell * grid.up;
}

std::unique_ptr<PoissonDiskBins::Workspace> PoissonDiskBins::takeWorkspace()
{
  const std::lock_guard<std::mutex> guard(this->Lock);
  if (this->Idle.empty())
  {
    return std::make_unique<Workspace>();
  }
  std::unique_ptr<Workspace> workspace = std::move(this->Idle.back());
  this->Idle.pop_back();
  return workspace;
}

void PoissonDiskBins::giveBack(std::unique_ptr<Workspace> workspace)
{
  const std::lock_guard<std::mutex> guard(this->Lock);
  this->Idle.push_back(std::move(workspace));
}

} // namespace ink
