// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/ContourSurface.h"

#include "Core/Hash.h"
#include "Core/IsFinite.h"
#include "Core/MortonOrder.h"
#include "Core/ParallelChunks.h"
#include "Core/ParallelSort.h"
#include "Mesh/OnePerPoint.h"

#include <glm/common.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace ink
{

namespace
{

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// The triangles whose points are finite, in the Morton order of their centers.
std::vector<std::uint32_t> orderFaces(const TriangleMesh& mesh)
{
  glm::dvec3 lower(std::numeric_limits<double>::infinity());
  glm::dvec3 upper = -lower;
  for (const glm::dvec3& point : mesh.points)
  {
    if (isFinite(point))
    {
      lower = glm::min(lower, point);
      upper = glm::max(upper, point);
    }
  }
  // Halved, since the difference of two doubles may be infinite.
  const glm::dvec3 size = 0.5 * upper - 0.5 * lower;
  const double cells = (1 << mortonBits) - 1;
  const double scale = 0.5 * cells / std::max({ size.x, size.y, size.z, 1e-300 });
  struct Face
  {
    std::uint64_t code;
    std::uint32_t triangle;
    auto operator<=>(const Face&) const = default;
  };
  std::vector<Face> faces(mesh.triangles.size());
  parallelForEach(faces.size(),
    [&](std::size_t i)
    {
      glm::dvec3 center(0.0);
      for (const std::uint32_t point : mesh.triangles[i])
      {
        center += (mesh.points[point] - lower) / 3.0;
      }
      faces[i].triangle = isFinite(center) ? static_cast<std::uint32_t>(i) : none;
      faces[i].code =
        isFinite(center) ? mortonOf(glm::uvec3(glm::clamp(center * scale, 0.0, cells))) : ~std::uint64_t(0);
    });
  std::erase_if(faces, [](const Face& face) { return face.triangle == none; });
  parallelSort(faces.begin(), faces.end());
  std::vector<std::uint32_t> order;
  order.reserve(faces.size());
  for (const Face& face : faces)
  {
    order.push_back(face.triangle);
  }
  return order;
}

std::uint64_t hashOf(const glm::dvec3& position)
{
  // The sum turns -0 into 0.
  return hash(std::bit_cast<std::uint64_t>(position.x + 0.0), std::bit_cast<std::uint64_t>(position.y + 0.0),
    std::bit_cast<std::uint64_t>(position.z + 0.0));
}

/// As unitOrZero, but also of what is so short or long that its square is zero or infinite.
glm::vec3 unitOfAnyLength(const glm::dvec3& v)
{
  const double largest = std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
  return largest > 0.0 && isFinite(v) ? glm::vec3(glm::normalize(v / largest)) : glm::vec3(0.0f);
}

} // namespace

ContourSurface::ContourSurface(const TriangleMesh& mesh, std::span<const glm::vec3> pointNormals)
{
  if (!pointNormals.empty())
  {
    checkOnePerPoint(mesh, pointNormals.size(), "normals");
  }
  this->faceIds = orderFaces(mesh);
  std::vector<std::uint32_t> cornerOf(mesh.points.size(), none);
  std::vector<std::uint32_t> next; // corner at the same position
  bool hasSplitSites = false;
  std::vector<std::uint32_t> slots(std::bit_ceil(2 * mesh.points.size() + 2), none);
  // The corner of a point: that of a point of the same position and normal, or a new one.
  const auto weld = [&](std::uint32_t point)
  {
    const glm::dvec3& position = mesh.points[point];
    const glm::vec3 normal =
      pointNormals.empty() ? glm::vec3(0.0f) : unitOfAnyLength(glm::dvec3(pointNormals[point]));
    std::size_t slot = hashOf(position) & (slots.size() - 1);
    while (slots[slot] != none && this->corners[slots[slot]].position != position)
    {
      slot = (slot + 1) & (slots.size() - 1);
    }
    const auto corner = static_cast<std::uint32_t>(this->corners.size());
    const std::uint32_t site = slots[slot] == none ? corner : slots[slot];
    std::uint32_t last = none;
    for (std::uint32_t other = slots[slot]; other != none; other = next[other])
    {
      if (this->corners[other].normal == normal)
      {
        return other;
      }
      last = other;
    }
    if (last == none)
    {
      slots[slot] = corner;
    }
    else
    {
      next[last] = corner;
      hasSplitSites = true;
    }
    this->corners.push_back({ position, normal });
    this->sites.push_back(site);
    next.push_back(none);
    return corner;
  };
  this->faces.reserve(this->faceIds.size());
  std::erase_if(this->faceIds,
    [&](std::uint32_t triangle)
    {
      Triangle face;
      for (int i = 0; i < 3; ++i)
      {
        const std::uint32_t point = mesh.triangles[triangle][i];
        cornerOf[point] = cornerOf[point] == none ? weld(point) : cornerOf[point];
        face[i] = cornerOf[point];
      }
      const auto& [a, b, c] = face;
      const bool collapsed = this->sites[a] == this->sites[b] || this->sites[b] == this->sites[c] ||
        this->sites[c] == this->sites[a];
      if (!collapsed)
      {
        this->faces.push_back(face);
      }
      return collapsed;
    });
  this->completeNormals(pointNormals.empty());
  if (hasSplitSites)
  {
    this->averageAtSites();
  }
  this->isInsideOut = this->pointsInwards();
  this->isClosed = this->hasNoBorder();
}

glm::dvec3 ContourSurface::areaVector(std::uint32_t face) const
{
  const auto& [a, b, c] = this->faces[face];
  return glm::cross(this->corners[b].position - this->corners[a].position,
    this->corners[c].position - this->corners[a].position);
}

glm::dvec3 ContourSurface::faceNormal(std::uint32_t face) const
{
  const glm::dvec3 area = this->areaVector(face);
  const double length = glm::length(area);
  if (length > 0.0 && std::isfinite(length))
  {
    return area / length;
  }
  const auto& [a, b, c] = this->faces[face];
  return glm::dvec3(
    unitOfAnyLength(glm::dvec3(this->corners[a].normal + this->corners[b].normal + this->corners[c].normal)));
}

void ContourSurface::averageAtSites()
{
  std::vector<glm::dvec3> sums(this->corners.size(), glm::dvec3(0.0));
  for (std::size_t corner = 0; corner < this->sites.size(); ++corner)
  {
    sums[this->sites[corner]] += glm::dvec3(this->corners[corner].normal);
  }
  for (std::size_t corner = 0; corner < this->sites.size(); ++corner)
  {
    const glm::vec3 mean = unitOfAnyLength(sums[this->sites[corner]]);
    this->siteNormals.push_back(mean == glm::vec3(0.0f) ? this->corners[corner].normal : mean);
  }
}

bool ContourSurface::pointsInwards() const
{
  // Six times the volume, with faces turned to the side of their normals.
  double volume = 0.0;
  for (std::uint32_t face = 0; face < this->faces.size(); ++face)
  {
    const auto& [a, b, c] = this->faces[face];
    const glm::dvec3 area = this->areaVector(face);
    const glm::dvec3 normal(this->corners[a].normal + this->corners[b].normal + this->corners[c].normal);
    const double part = glm::dot(area, this->corners[a].position - this->corners[0].position);
    volume += glm::dot(area, normal) < 0.0 ? -part : part;
  }
  return volume < 0.0;
}

bool ContourSurface::hasNoBorder() const
{
  // Those of an edge with an even number of faces cancel out.
  std::uint64_t sum = 0;
  for (const Triangle& face : this->faces)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto [low, high] = std::minmax(this->sites[face[i]], this->sites[face[(i + 1) % 3]]);
      sum ^= hash(low, high);
    }
  }
  return sum == 0;
}

void ContourSurface::completeNormals(bool all)
{
  const glm::vec3 zero(0.0f);
  if (!all &&
    std::none_of(this->corners.begin(), this->corners.end(),
      [&](const Corner& corner) { return corner.normal == zero; }))
  {
    return;
  }
  std::vector<glm::dvec3> around(this->corners.size(), glm::dvec3(0.0)); // of faces
  std::vector<glm::dvec3> given(all ? 0 : this->corners.size(), glm::dvec3(0.0));
  for (std::uint32_t face = 0; face < this->faces.size(); ++face)
  {
    const glm::dvec3 area = this->areaVector(face);
    for (const std::uint32_t corner : this->faces[face])
    {
      around[corner] += area;
      for (const std::uint32_t other : this->faces[face])
      {
        if (!all)
        {
          given[corner] += glm::dvec3(this->corners[other].normal);
        }
      }
    }
  }
  for (std::size_t corner = 0; corner < this->corners.size(); ++corner)
  {
    if (this->corners[corner].normal == zero && !all)
    {
      this->corners[corner].normal = unitOfAnyLength(given[corner]);
    }
    if (this->corners[corner].normal == zero)
    {
      this->corners[corner].normal = unitOfAnyLength(around[corner]);
    }
  }
}

} // namespace ink
