// SPDX-License-Identifier: BSD-3-Clause
#include "Curvature/AveragedCurvature.h"

#include "Core/Hash.h"
#include "Core/IsFinite.h"
#include "Core/ParallelChunks.h"
#include "Mesh/OnePerPoint.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace ink
{

namespace
{

/// The parts of a sum: of the symmetric tensor xx, xy, xz, yy, yz, zz, and of the weights.
using Sum = std::array<double, 7>;

/// At a corner of the grid: of normals along x, y, z and against them.
using Layers = std::array<Sum, 6>;

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

class FormGrid
{
public:
  FormGrid(const glm::dvec3& lower, double width)
    : Lower(lower)
    , Width(width)
  {
  }

  void add(const glm::dvec3& position, const glm::dvec3& normal, const Sum& sum)
  {
    const Cell cell = this->cellOf(position);
    const auto found = this->Cells.try_emplace(cell.index, Corners{}).first;
    if (found->second[0] == none)
    {
      for (int corner = 0; corner < 8; ++corner)
      {
        const glm::ivec3 at = cell.index + offset(corner);
        const auto next = static_cast<std::uint32_t>(this->Sums.size());
        const auto [entry, isNew] = this->CornerNumbers.try_emplace(at, next);
        found->second[static_cast<std::size_t>(corner)] = entry->second;
        if (isNew)
        {
          this->Sums.emplace_back();
        }
      }
    }
    this->forLayers(found->second, cell.share, normal,
      [&](std::uint32_t corner, std::size_t layer, double weight)
      {
        for (std::size_t i = 0; i < sum.size(); ++i)
        {
          this->Sums[corner][layer][i] += weight * sum[i];
        }
      });
  }

  /// Of a position and normal that something was added at.
  Sum at(const glm::dvec3& position, const glm::dvec3& normal) const
  {
    Sum result{};
    const Cell cell = this->cellOf(position);
    if (const auto found = this->Cells.find(cell.index); found != this->Cells.end())
    {
      this->forLayers(found->second, cell.share, normal,
        [&](std::uint32_t corner, std::size_t layer, double weight)
        {
          for (std::size_t i = 0; i < result.size(); ++i)
          {
            result[i] += weight * this->Sums[corner][layer][i];
          }
        });
    }
    return result;
  }

private:
  struct Corners : std::array<std::uint32_t, 8>
  {
    Corners() { this->fill(none); }
  };
  struct Cell
  {
    glm::ivec3 index;
    glm::dvec3 share; ///< of the way to the next
  };
  struct CellHash
  {
    std::size_t operator()(const glm::ivec3& cell) const
    {
      const auto part = [](int i) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(i)); };
      return hash(part(cell.x) << 32 | part(cell.y), part(cell.z));
    }
  };

  Cell cellOf(const glm::dvec3& position) const
  {
    // Beyond that, cells are below what tells positions apart.
    constexpr double most = 1e9;
    const glm::dvec3 at = glm::clamp((position - this->Lower) / this->Width, 0.0, most);
    const glm::dvec3 whole = glm::floor(at);
    return { glm::ivec3(whole), at - whole };
  }
  static glm::ivec3 offset(int corner) { return { corner & 1, corner >> 1 & 1, corner >> 2 }; }

  template <class Use>
  void forLayers(
    const Corners& corners, const glm::dvec3& share, const glm::dvec3& normal, const Use& use) const
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::dvec3 near = glm::mix(1.0 - share, share, glm::dvec3(offset(corner)));
      for (int axis = 0; axis < 3; ++axis)
      {
        const auto layer = static_cast<std::size_t>(normal[axis] < 0.0 ? axis + 3 : axis);
        use(corners[static_cast<std::size_t>(corner)], layer,
          near.x * near.y * near.z * normal[axis] * normal[axis]);
      }
    }
  }

  glm::dvec3 Lower;
  double Width;
  std::unordered_map<glm::ivec3, Corners, CellHash> Cells;
  std::unordered_map<glm::ivec3, std::uint32_t, CellHash> CornerNumbers;
  std::vector<Layers> Sums;
};

/// The area around each point: a third of its triangles'.
std::vector<double> areasOf(const TriangleMesh& mesh)
{
  std::vector<double> areas(mesh.points.size());
  for (const auto& [a, b, c] : mesh.triangles)
  {
    const double area =
      glm::length(glm::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a])) / 6.0;
    for (const std::uint32_t point : { a, b, c })
    {
      areas[point] += std::isfinite(area) ? area : 0.0;
    }
  }
  return areas;
}

/// @param weight that it counts with
Sum sumOf(const PrincipalCurvature& at, double weight, double most)
{
  Sum sum{};
  sum[6] = weight;
  if (std::isfinite(at.k1) && std::isfinite(at.k2) && isFinite(at.direction1) && isFinite(at.direction2))
  {
    const double k1 = weight * std::clamp(at.k1, -most, most);
    const double k2 = weight * std::clamp(at.k2, -most, most);
    std::size_t entry = 0;
    for (int row = 0; row < 3; ++row)
    {
      for (int column = row; column < 3; ++column)
      {
        sum[entry++] =
          k1 * at.direction1[row] * at.direction1[column] + k2 * at.direction2[row] * at.direction2[column];
      }
    }
  }
  return sum;
}

PrincipalCurvature curvatureOf(const Sum& sum, const glm::dvec3& normal)
{
  const auto [x, y] = tangentAxes(normal);
  const auto form = [&](const glm::dvec3& a, const glm::dvec3& b)
  {
    const glm::dvec3 image(sum[0] * b.x + sum[1] * b.y + sum[2] * b.z,
      sum[1] * b.x + sum[3] * b.y + sum[4] * b.z, sum[2] * b.x + sum[4] * b.y + sum[5] * b.z);
    return glm::dot(a, image) / sum[6];
  };
  return principalCurvature({ form(x, x), form(x, y), form(y, y) }, x, y);
}

} // namespace

std::vector<PrincipalCurvature> averagedCurvature(const TriangleMesh& mesh,
  std::span<const glm::vec3> normals, std::span<const PrincipalCurvature> curvatures, double width,
  double most)
{
  checkOnePerPoint(mesh, normals.size(), "normals");
  checkOnePerPoint(mesh, curvatures.size(), "curvatures");
  const std::vector<double> areas = areasOf(mesh);
  const auto isUsed = [&](std::size_t i)
  { return areas[i] > 0.0 && normals[i] != glm::vec3(0.0f) && isFinite(mesh.points[i]); };
  glm::dvec3 lower(std::numeric_limits<double>::max());
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    lower = isUsed(i) ? glm::min(lower, mesh.points[i]) : lower;
  }
  FormGrid grid(lower, width);
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    if (isUsed(i))
    {
      grid.add(mesh.points[i], glm::dvec3(normals[i]), sumOf(curvatures[i], areas[i], most));
    }
  }
  std::vector<PrincipalCurvature> result(areas.size());
  parallelForEach(areas.size(),
    [&](std::size_t i)
    {
      if (!isUsed(i))
      {
        return;
      }
      if (const Sum sum = grid.at(mesh.points[i], glm::dvec3(normals[i])); sum[6] > 0.0)
      {
        result[i] = curvatureOf(sum, glm::dvec3(normals[i]));
      }
    });
  return result;
}

} // namespace ink
