// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/GeodesicUnfolding.h"

#include "Core/Hash.h"
#include "Core/ParallelChunks.h"
#include "Core/UnitOrZero.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace ink
{

namespace
{

constexpr std::uint32_t none = ~0u;

/// For each point the first one at the same position.
std::vector<std::uint32_t> firstAtPosition(std::span<const glm::vec3> points)
{
  const std::size_t slots = std::bit_ceil(2 * points.size() + 1);
  std::vector<std::uint32_t> table(slots, none);
  std::vector<std::uint32_t> first(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i)
  {
    // Adding zero turns -0 into 0.
    const glm::vec3 point = points[i] + 0.0f;
    const std::uint64_t bits = hash(std::bit_cast<std::uint32_t>(point.x),
      std::uint64_t(std::bit_cast<std::uint32_t>(point.y)) << 32 | std::bit_cast<std::uint32_t>(point.z));
    std::size_t slot = bits & (slots - 1);
    while (table[slot] != none && points[table[slot]] != point)
    {
      slot = (slot + 1) & (slots - 1);
    }
    if (table[slot] == none)
    {
      table[slot] = i;
    }
    first[i] = table[slot];
  }
  return first;
}

} // namespace

void GeodesicUnfolding::Front::begin()
{
  this->Entries.clear();
  this->Entered = 0;
  if (++this->Round == 0)
  {
    std::fill(this->Slots.begin(), this->Slots.end(), Slot());
    this->Round = 1;
  }
}

void GeodesicUnfolding::Front::grow()
{
  std::vector<Slot> slots(4 * this->Slots.size());
  std::swap(slots, this->Slots);
  this->Entered = 0;
  for (const Slot& slot : slots)
  {
    if (slot.round == this->Round)
    {
      this->enter(slot.triangle);
    }
  }
}

GeodesicUnfolding::GeodesicUnfolding(std::span<const glm::vec3> points, std::span<const Triangle> triangles)
  : Facets(triangles.size())
{
  parallelForEach(triangles.size(),
    [&](std::size_t t)
    {
      const auto& [a, b, c] = triangles[t];
      Facet& facet = this->Facets[t];
      facet.corners = { points[a], points[b], points[c] };
      facet.normal =
        unitOrZero(glm::cross(facet.corners[1] - facet.corners[0], facet.corners[2] - facet.corners[0]));
    });
  this->join(points.size(), triangles, {});
  const bool isOpen = std::any_of(this->Facets.begin(), this->Facets.end(),
    [](const Facet& facet)
    { return facet.across[0] == border || facet.across[1] == border || facet.across[2] == border; });
  if (isOpen)
  {
    this->join(points.size(), triangles, firstAtPosition(points));
  }
}

void GeodesicUnfolding::join(
  std::size_t pointCount, std::span<const Triangle> triangles, std::span<const std::uint32_t> pointIds)
{
  const auto id = [&](std::uint32_t point) { return pointIds.empty() ? point : pointIds[point]; };
  // For each point, a list of the edges with it as the lower index, one per upper index.
  struct Link
  {
    std::uint32_t upper;
    std::uint32_t next;
  };
  std::vector<std::uint32_t> heads(pointCount, none);
  std::vector<Link> links(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
  {
    const Triangle& corners = triangles[t];
    const std::uint32_t ids[3] = { id(corners[0]), id(corners[1]), id(corners[2]) };
    for (std::uint32_t e = 0; e < 3; ++e)
    {
      const std::uint32_t a = ids[e];
      const std::uint32_t b = ids[e == 2 ? 0 : e + 1];
      const std::uint32_t upper = std::max(a, b);
      std::uint32_t& head = heads[std::min(a, b)];
      const std::uint32_t edge = 3 * t + e;
      std::uint32_t other = head;
      while (other != none && links[other].upper != upper)
      {
        other = links[other].next;
      }
      if (other == none)
      {
        links[edge] = { upper, head };
        head = edge;
        this->Facets[t].across[e] = border;
      }
      else
      {
        // Inserted into the ring after the edge found.
        std::uint32_t& behind = this->Facets[other / 3].across[other % 3];
        this->Facets[t].across[e] = behind == border ? other : behind;
        behind = edge;
      }
    }
  }
}

GeodesicUnfolding::Front::Entry GeodesicUnfolding::turn(
  const Front::Entry& from, std::uint32_t exit, std::uint32_t entry) const
{
  const std::uint32_t triangle = entry / 3;
  glm::vec3 normal = this->Facets[triangle].normal;
  float likeness = glm::dot(from.normal, normal);
  // Consistently oriented triangles traverse their common edge in opposite directions.
  if (likeness < 0.0f && this->corner(exit, 0) == this->corner(entry, 0))
  {
    normal = -normal;
    likeness = -likeness;
  }
  const glm::vec3 start = this->corner(exit, 0);
  glm::vec3 along = this->corner(exit, 1) - start;
  const auto away = [&](const glm::vec3& offset) { return offset - glm::dot(offset, along) * along; };
  const float length = glm::length(along);
  // Degenerate triangles have no plane to rotate into.
  if (likeness > nearlyFlat || normal == glm::vec3(0.0f) || !(length > 0.0f))
  {
    return { triangle, from.image, from.normal == glm::vec3(0.0f) ? normal : from.normal };
  }
  along /= length;
  const glm::vec3 inwards = away(this->corner(entry, 2) - start);
  const float height = glm::length(inwards);
  if (!(height > 0.0f))
  {
    return { triangle, from.image, from.normal };
  }
  const glm::vec3 offset = from.image - start;
  const glm::vec3 side = away(offset);
  const float sign = glm::dot(side, away(this->corner(exit, 2) - start)) < 0.0f ? 1.0f : -1.0f;
  return { triangle, start + glm::dot(offset, along) * along + (sign * glm::length(side) / height) * inwards,
    normal };
}

} // namespace ink
