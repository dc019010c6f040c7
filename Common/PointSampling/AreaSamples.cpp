// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/AreaSamples.h"

#include "Core/Hash.h"
#include "Core/ParallelChunks.h"
#include "Core/UnitOrZero.h"
#include "PointSampling/SampleGroups.h"

#include <glm/geometric.hpp>

#include <array>
#include <cstdint>

namespace ink
{

namespace
{

/// Of the square of the edge: smaller parts, of slivers, are not cut into even smaller ones, so that a fan of
/// many thousands of slivers has no more parts than its area takes.
constexpr double leastPart = 1.0 / 64.0;

struct Part
{
  std::array<glm::dvec3, 3> corners;
  double area;
};

/// A position in a part that is longer than the edge, by chance: those in the middle of many slivers side by
/// side would be in rows.
glm::dvec3 scatteredIn(const Part& part, std::uint64_t bits)
{
  double b = unitDouble(bits);
  double c = unitDouble(hash(bits));
  if (b + c > 1.0)
  {
    b = 1.0 - b;
    c = 1.0 - c;
  }
  return part.corners[0] + b * (part.corners[1] - part.corners[0]) + c * (part.corners[2] - part.corners[0]);
}

/// Halves a triangle at its longest edge until its parts are small enough.
template <class Take>
void cutTriangle(const Part& whole, double edge, std::uint64_t id, const Take& take)
{
  std::vector<Part> left{ whole };
  std::uint64_t taken = 0;
  while (!left.empty())
  {
    const Part part = left.back();
    left.pop_back();
    const auto squared = [&](std::size_t i)
    {
      const glm::dvec3 side = part.corners[(i + 1) % 3] - part.corners[i];
      return glm::dot(side, side);
    };
    const std::size_t first = squared(0) >= squared(1) ? 0 : 1;
    const std::size_t longest = squared(first) >= squared(2) ? first : 2;
    const bool isSmall = squared(longest) <= edge * edge;
    if (isSmall || part.area <= leastPart * edge * edge)
    {
      take(isSmall ? (part.corners[0] + part.corners[1] + part.corners[2]) / 3.0
                   : scatteredIn(part, hash(id, taken++)),
        part.area);
      continue;
    }
    const glm::dvec3& a = part.corners[longest];
    const glm::dvec3& b = part.corners[(longest + 1) % 3];
    const glm::dvec3& c = part.corners[(longest + 2) % 3];
    const glm::dvec3 middle = 0.5 * a + 0.5 * b;
    left.push_back({ { a, middle, c }, 0.5 * part.area });
    left.push_back({ { middle, b, c }, 0.5 * part.area });
  }
}

} // namespace

AreaSamples areaSamples(const TriangleMesh& mesh, std::span<const glm::vec3> normals,
  const glm::dvec3& center, double unit, float edge)
{
  std::vector<AreaSamples> chunks(chunksOf(mesh.triangles.size()));
  parallelForChunks(mesh.triangles.size(),
    [&](std::size_t chunk, std::size_t begin, std::size_t end)
    {
      AreaSamples& own = chunks[chunk];
      for (std::size_t i = begin; i < end; ++i)
      {
        const double area = areaOf(mesh, i) / (unit * unit);
        const auto& [a, b, c] = mesh.triangles[i];
        if (!(area > 0.0))
        {
          continue;
        }
        const glm::vec3 normal = unitOrZero(normals[a] + normals[b] + normals[c]);
        const Part whole{ { (mesh.points[a] - center) / unit, (mesh.points[b] - center) / unit,
                            (mesh.points[c] - center) / unit },
          area };
        cutTriangle(whole, static_cast<double>(edge), i,
          [&](const glm::dvec3& middle, double part)
          {
            const auto rounded = static_cast<float>(part);
            if (rounded > 0.0f)
            {
              own.positions.emplace_back(middle);
              own.normals.push_back(normal);
              own.areas.push_back(rounded);
            }
          });
      }
    });
  AreaSamples samples;
  for (const AreaSamples& chunk : chunks)
  {
    samples.positions.insert(samples.positions.end(), chunk.positions.begin(), chunk.positions.end());
    samples.normals.insert(samples.normals.end(), chunk.normals.begin(), chunk.normals.end());
    samples.areas.insert(samples.areas.end(), chunk.areas.begin(), chunk.areas.end());
  }
  return samples;
}

AreaSamples joinSamples(const AreaSamples& samples, float edge)
{
  const SampleGroups groups = groupSamples(samples.positions, samples.normals, edge);
  const std::size_t count = groups.begins.size() - 1;
  AreaSamples result;
  result.positions.resize(count);
  result.normals.resize(count);
  result.areas.resize(count);
  parallelForEach(count,
    [&](std::size_t group)
    {
      glm::dvec3 position(0.0);
      glm::vec3 normal(0.0f);
      double area = 0.0;
      for (std::size_t i = groups.begins[group]; i < groups.begins[group + 1]; ++i)
      {
        const std::uint32_t sample = groups.samples[i];
        const auto own = static_cast<double>(samples.areas[sample]);
        position += own * glm::dvec3(samples.positions[sample]);
        normal += samples.areas[sample] * samples.normals[sample];
        area += own;
      }
      result.positions[group] = glm::vec3(position / area);
      result.normals[group] = unitOrZero(normal);
      result.areas[group] = static_cast<float>(area);
    });
  return result;
}

} // namespace ink
