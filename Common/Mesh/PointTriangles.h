// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mesh/TriangleMesh.h"

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace ink
{

/// The triangles around each point of a mesh, ascending.
class PointTriangles
{
public:
  /// @param mesh each triangle's points exist
  explicit PointTriangles(const TriangleMesh& mesh)
    : Begins(mesh.points.size() + 2)
    , Triangles(3 * mesh.triangles.size())
  {
    for (const Triangle& triangle : mesh.triangles)
    {
      for (const std::uint32_t point : triangle)
      {
        ++this->Begins[point + 2];
      }
    }
    std::partial_sum(this->Begins.begin(), this->Begins.end(), this->Begins.begin());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      for (const std::uint32_t point : mesh.triangles[t])
      {
        this->Triangles[this->Begins[point + 1]++] = static_cast<std::uint32_t>(t);
      }
    }
  }

  std::span<const std::uint32_t> of(std::size_t point) const
  {
    return std::span(this->Triangles)
      .subspan(this->Begins[point], this->Begins[point + 1] - this->Begins[point]);
  }

private:
  std::vector<std::size_t> Begins;
  std::vector<std::uint32_t> Triangles;
};

} // namespace ink
