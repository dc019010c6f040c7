// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/FaceOrder.h"

#include "Core/ParallelSort.h"

#include <algorithm>
#include <array>
#include <bit>
#include <tuple>

namespace ink
{

namespace
{

/// A key with the order of the coordinate, NaN included; equal for -0 and 0.
std::uint64_t orderedBits(double coordinate)
{
  const auto bits = std::bit_cast<std::uint64_t>(coordinate + 0.0);
  return bits >> 63 != 0 ? ~bits : bits | std::uint64_t(1) << 63;
}

using Corner = std::array<std::uint64_t, 3>;

Corner cornerAt(const glm::dvec3& point)
{
  return { orderedBits(point.x), orderedBits(point.y), orderedBits(point.z) };
}

struct Face
{
  Corner first;
  std::uint32_t begin; // of its triangles
  std::uint32_t end;
};

} // namespace

std::vector<std::uint32_t> orderByPosition(std::span<const glm::dvec3> points,
  std::span<const Triangle> triangles, std::span<const std::uint32_t> firsts)
{
  std::vector<Face> faces;
  faces.reserve(firsts.size());
  for (std::size_t face = 0; face < firsts.size(); ++face)
  {
    const std::uint32_t begin = firsts[face];
    const auto end =
      face + 1 < firsts.size() ? firsts[face + 1] : static_cast<std::uint32_t>(triangles.size());
    faces.push_back({ cornerAt(points[triangles[begin][0]]), begin, end });
  }
  const auto isBefore = [&](const Face& a, const Face& b)
  {
    if (a.first != b.first)
    {
      return a.first < b.first;
    }
    const std::uint32_t length = std::min(a.end - a.begin, b.end - b.begin);
    for (std::uint32_t i = 0; i < 3 * length; ++i)
    {
      const Corner ofA = cornerAt(points[triangles[a.begin + i / 3][i % 3]]);
      const Corner ofB = cornerAt(points[triangles[b.begin + i / 3][i % 3]]);
      if (ofA != ofB)
      {
        return ofA < ofB;
      }
    }
    return std::tuple(a.end - a.begin, a.begin) < std::tuple(b.end - b.begin, b.begin);
  };
  parallelSort(faces.begin(), faces.end(), isBefore);
  std::vector<std::uint32_t> order;
  order.reserve(triangles.size());
  for (const Face& face : faces)
  {
    for (std::uint32_t t = face.begin; t < face.end; ++t)
    {
      order.push_back(t);
    }
  }
  return order;
}

} // namespace ink
