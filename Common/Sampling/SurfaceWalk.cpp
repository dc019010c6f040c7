#include "Sampling/SurfaceWalk.h"

#include "Parallel/ParallelFor.h"
#include "Sampling/Hash.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace ink
{

namespace
{

constexpr std::uint32_t border = ~0u;
constexpr std::uint32_t branch = ~0u - 1; // more than two triangles share the edge
constexpr std::size_t blockSize = 1 << 13;
// A way that goes round and round a point without getting on.
constexpr int mostSteps = 4096;
// Of the limit: so near to the way a place has been reached. Rounding may lead the way past its triangle.
constexpr float reached = 1e-3f;

std::size_t blocksOf(std::size_t count)
{
  return (count + blockSize - 1) / blockSize;
}

/// For each point the first one at the same position.
std::vector<std::uint32_t> firstAtPosition(std::span<const glm::vec3> points)
{
  const std::size_t slots = std::bit_ceil(2 * points.size() + 1);
  std::vector<std::uint32_t> table(slots, border);
  std::vector<std::uint32_t> first(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i)
  {
    // Adding zero makes -0 and 0 the same.
    const glm::vec3 point = points[i] + 0.0f;
    const std::uint64_t bits = hash(std::bit_cast<std::uint32_t>(point.x),
      std::uint64_t(std::bit_cast<std::uint32_t>(point.y)) << 32 | std::bit_cast<std::uint32_t>(point.z));
    std::size_t slot = bits & (slots - 1);
    while (table[slot] != border && points[table[slot]] != point)
    {
      slot = (slot + 1) & (slots - 1);
    }
    if (table[slot] == border)
    {
      table[slot] = i;
    }
    first[i] = table[slot];
  }
  return first;
}

} // namespace

struct SurfaceWalk::Cut
{
  glm::vec3 normal;
  glm::vec3 origin;
  float side(const glm::vec3& point) const { return glm::dot(this->normal, point - this->origin); }
};

SurfaceWalk::SurfaceWalk(std::span<const glm::vec3> points, std::span<const Triangle> triangles)
  : Points(points)
  , Triangles(triangles)
  , Normals(triangles.size())
  , Across(3 * triangles.size())
{
  parallelFor(blocksOf(triangles.size()),
    [&](std::size_t block)
    {
      for (std::size_t t = block * blockSize; t < std::min((block + 1) * blockSize, triangles.size()); ++t)
      {
        const auto& [a, b, c] = triangles[t];
        const glm::vec3 normal = glm::cross(points[b] - points[a], points[c] - points[a]);
        const float length = glm::length(normal);
        this->Normals[t] = length > 0.0f && std::isfinite(length) ? normal / length : glm::vec3(0.0f);
      }
    });
  this->join({});
  if (std::find(this->Across.begin(), this->Across.end(), border) != this->Across.end())
  {
    this->join(firstAtPosition(points));
  }
}

void SurfaceWalk::join(std::span<const std::uint32_t> pointNames)
{
  const auto name = [&](std::uint32_t point) { return pointNames.empty() ? point : pointNames[point]; };
  const auto ends = [&](std::uint32_t edge)
  {
    const Triangle& corners = this->Triangles[edge / 3];
    const std::uint32_t e = edge % 3;
    const std::uint32_t a = name(corners[e]);
    const std::uint32_t b = name(corners[e == 2 ? 0 : e + 1]);
    return std::pair(std::min(a, b), std::max(a, b));
  };
  // The edges of each lower end, one after the other.
  const auto edgeCount = static_cast<std::uint32_t>(3 * this->Triangles.size());
  std::vector<std::uint32_t> begin(this->Points.size() + 1);
  std::vector<std::uint32_t> upper(edgeCount);
  std::vector<std::uint32_t> lower(edgeCount);
  for (std::uint32_t edge = 0; edge < edgeCount; ++edge)
  {
    const auto [low, high] = ends(edge);
    lower[edge] = low;
    upper[edge] = high;
    ++begin[low + 1];
  }
  for (std::size_t i = 1; i < begin.size(); ++i)
  {
    begin[i] += begin[i - 1];
  }
  std::vector<std::uint32_t> edges(edgeCount);
  std::vector<std::uint32_t> end(begin.begin(), begin.end() - 1);
  for (std::uint32_t edge = 0; edge < edgeCount; ++edge)
  {
    edges[end[lower[edge]]++] = edge;
  }
  parallelFor(blocksOf(edgeCount),
    [&](std::size_t block)
    {
      const auto last = static_cast<std::uint32_t>(std::min<std::size_t>((block + 1) * blockSize, edgeCount));
      for (auto edge = static_cast<std::uint32_t>(block * blockSize); edge < last; ++edge)
      {
        this->Across[edge] = border;
        for (std::uint32_t i = begin[lower[edge]]; i < end[lower[edge]]; ++i)
        {
          if (const std::uint32_t other = edges[i]; other != edge && upper[other] == upper[edge])
          {
            this->Across[edge] = this->Across[edge] == border ? other : branch;
          }
        }
      }
    });
}

float SurfaceWalk::distance(const Place& from, const Place& to, float limit) const
{
  const glm::vec3 straight = to.position - from.position;
  if (from.triangle == to.triangle)
  {
    return glm::length(straight);
  }
  const glm::vec3 a = this->Normals[from.triangle];
  const glm::vec3 b = this->Normals[to.triangle];
  const float likeness = glm::dot(a, b);
  const glm::vec3 up = likeness > -0.95f ? a + b : a;
  glm::vec3 across = glm::cross(straight, up);
  const float size = glm::length(across);
  if (!(size > 1e-6f * glm::length(straight)))
  {
    // The same place, in triangles that touch there, or one above the other.
    return glm::length(straight) <= reached * limit ? glm::length(straight) : unreachable;
  }
  const Cut cut{ across / size, from.position };
  const float length = this->walk(from, to, cut, true, limit);
  // Round a fold the way may begin in the other direction.
  return length == unreachable && likeness < 0.5f ? this->walk(from, to, cut, false, limit) : length;
}

float SurfaceWalk::walk(const Place& from, const Place& to, const Cut& cut, bool forward, float limit) const
{
  const glm::vec3 straight = forward ? to.position - from.position : from.position - to.position;
  glm::vec3 place = from.position;
  std::uint32_t triangle = from.triangle;
  std::uint32_t entry = border;
  float length = 0.0f;
  for (int step = 0; step < mostSteps; ++step)
  {
    const Triangle& corners = this->Triangles[triangle];
    const glm::vec3 points[3] = { this->Points[corners[0]], this->Points[corners[1]],
      this->Points[corners[2]] };
    const float sides[3] = { cut.side(points[0]), cut.side(points[1]), cut.side(points[2]) };
    std::uint32_t exit = border;
    glm::vec3 next(0.0f);
    float best = -std::numeric_limits<float>::infinity();
    for (std::uint32_t e = 0; e < 3; ++e)
    {
      const std::uint32_t f = e == 2 ? 0 : e + 1;
      if (3 * triangle + e == entry || (sides[e] >= 0.0f) == (sides[f] >= 0.0f))
      {
        continue;
      }
      const glm::vec3 crossing = points[e] + (sides[e] / (sides[e] - sides[f])) * (points[f] - points[e]);
      const float along = glm::dot(crossing - from.position, straight);
      // Two edges are left only where the way begins.
      if (along > best)
      {
        best = along;
        exit = 3 * triangle + e;
        next = crossing;
      }
    }
    if (exit == border)
    {
      return unreachable;
    }
    const glm::vec3 stride = next - place;
    const float squared = glm::dot(stride, stride);
    const float part =
      squared > 0.0f ? std::clamp(glm::dot(to.position - place, stride) / squared, 0.0f, 1.0f) : 0.0f;
    const glm::vec3 missed = to.position - (place + part * stride);
    if (glm::dot(missed, missed) < reached * reached * limit * limit)
    {
      length += part * std::sqrt(squared);
      return length < limit ? length : unreachable;
    }
    length += std::sqrt(squared);
    const float left = glm::distance(to.position, next);
    if (!(length + left < limit))
    {
      return unreachable;
    }
    entry = this->Across[exit];
    place = next;
    if (entry == branch)
    {
      return length + left;
    }
    if (entry == border)
    {
      const Step start{ exit, place, length };
      const bool upwards = glm::distance(this->edgeEnd(exit, true), to.position) <
        glm::distance(this->edgeEnd(exit, false), to.position);
      Step end = this->followBorder(start, cut, upwards, limit);
      if (end.edge == border)
      {
        end = this->followBorder(start, cut, !upwards, limit);
      }
      if (end.edge == border)
      {
        return unreachable;
      }
      entry = end.edge;
      place = end.place;
      length = end.length;
    }
    triangle = entry / 3;
    if (triangle == to.triangle)
    {
      length += glm::distance(to.position, place);
      return length < limit ? length : unreachable;
    }
  }
  return unreachable;
}

const glm::vec3& SurfaceWalk::edgeEnd(std::uint32_t edge, bool upper) const
{
  const std::uint32_t corner = edge % 3 + (upper ? 1 : 0);
  return this->Points[this->Triangles[edge / 3][corner % 3]];
}

std::uint32_t SurfaceWalk::nextOnBorder(std::uint32_t edge, const glm::vec3& pivot) const
{
  for (int step = 0; step < mostSteps; ++step)
  {
    // The triangle's other edge at the pivot.
    const std::uint32_t first = edge - edge % 3;
    for (std::uint32_t other = first; other < first + 3; ++other)
    {
      if (other != edge && (this->edgeEnd(other, false) == pivot || this->edgeEnd(other, true) == pivot))
      {
        edge = other;
        break;
      }
    }
    const std::uint32_t across = this->Across[edge];
    if (across == border || across == branch)
    {
      return across == border ? edge : branch;
    }
    edge = across;
  }
  return branch;
}

SurfaceWalk::Step SurfaceWalk::followBorder(const Step& from, const Cut& cut, bool upwards, float limit) const
{
  const Step none{ border, {}, 0.0f };
  Step step = from;
  glm::vec3 end = this->edgeEnd(step.edge, upwards);
  for (int i = 0; i < mostSteps; ++i)
  {
    step.length += glm::distance(step.place, end);
    step.place = end;
    step.edge = this->nextOnBorder(step.edge, end);
    if (!(step.length < limit) || step.edge == branch || step.edge == from.edge)
    {
      return none;
    }
    end = this->edgeEnd(step.edge, this->edgeEnd(step.edge, false) == step.place);
    const float here = cut.side(step.place);
    const float there = cut.side(end);
    if ((here >= 0.0f) != (there >= 0.0f))
    {
      const glm::vec3 crossing = step.place + (here / (here - there)) * (end - step.place);
      step.length += glm::distance(step.place, crossing);
      step.place = crossing;
      return step.length < limit ? step : none;
    }
  }
  return none;
}

} // namespace ink
