// SPDX-License-Identifier: BSD-3-Clause
#include "Stippling/VolumeStipples.h"

#include "Core/Hash.h"
#include "Core/ParallelFor.h"
#include "Fields/Grid/GridGeometry.h"
#include "Simd/SamplingKernels.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace ink::stipple
{
namespace
{

static_assert(maximumStipplesPerVoxel <= VoxelFill::MostStipples && sizeof(glm::vec3) == 3 * sizeof(float));

/// The distance, in units of the square root of the area per stipple, from which stipples are ignored: on a
/// surface one voxel thick, hardly any position is farther than that from the nearest stipple.
constexpr float sight = 0.65f;

/// The rank of a parity class (x + 2 y + 4 z) in Gray code order 000 001 011 010 110 111 101 100.
constexpr std::array<int, 8> grayOrder{ 0, 1, 3, 2, 7, 6, 4, 5 };

int parityClass(const glm::ivec3& global)
{
  return (global.x & 1) | (global.y & 1) << 1 | (global.z & 1) << 2;
}

/// Axes of the plane with a unit normal, in the units to which `toUnits` maps sample steps; and an upper
/// bound on the distance of a voxel's corners from its center, projected on it.
float setPlane(const glm::dvec3& normal, const glm::dmat3& toUnits, VoxelFill& voxel)
{
  // Duff et al. 2017, listing 3.
  const double sign = std::copysign(1.0, normal.z);
  const double a = -1.0 / (sign + normal.z);
  const double b = normal.x * normal.y * a;
  const glm::vec3 x(glm::dvec3(1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x) * toUnits);
  const glm::vec3 y(glm::dvec3(b, sign + normal.y * normal.y * a, -normal.y) * toUnits);
  for (int axis = 0; axis < 3; ++axis)
  {
    voxel.planeX[axis] = x[axis];
    voxel.planeY[axis] = y[axis];
  }
  const glm::vec3 sizeX = glm::abs(x);
  const glm::vec3 sizeY = glm::abs(y);
  return 0.5f * glm::length(glm::vec2(sizeX.x + sizeX.y + sizeX.z, sizeY.x + sizeY.y + sizeY.z));
}

/// The candidates for stipples: positions in a voxel between the planes.
/// @param normal the planes' unit normal, in sample steps
/// @param thickness the distance between the planes, in sample steps
void setCandidates(const glm::vec3& normal, float thickness, std::uint64_t random, VoxelFill& voxel)
{
  const glm::vec3 size = glm::abs(normal);
  voxel.solved = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const float inverse = 1.0f / normal[voxel.solved];
  voxel.slope[0] = normal[(voxel.solved + 1) % 3] * inverse;
  voxel.slope[1] = normal[(voxel.solved + 2) % 3] * inverse;
  // The extent of the voxel along the normal.
  voxel.height = std::min(thickness, size.x + size.y + size.z) * inverse;
  voxel.start[0] = static_cast<std::uint32_t>(random);
  voxel.start[1] = static_cast<std::uint32_t>(random >> 32);
  voxel.start[2] = static_cast<std::uint32_t>(hash(random));
}

/// Fills voxels sequentially; one object per parallel task.
class VoxelFiller
{
public:
  VoxelFiller(const GridGeometry& geometry, const StippledVoxels& voxels, const VolumeStippleOptions& options,
    std::vector<glm::vec3>& stipples)
    : Geometry(geometry)
    , Voxels(voxels)
    , Options(options)
    , Count(static_cast<std::size_t>(options.perVoxel))
    , Stipples(stipples)
    , Near(3 * (27 * Count + 2 * VoxelFill::Lanes))
  {
    const glm::dmat3& steps = geometry.stepToWorld();
    this->ToUnits = steps * (1.0 / std::cbrt(std::abs(glm::determinant(steps))));
    const std::size_t room = this->Near.size() / 3;
    this->Voxel.nearX = this->Near.data();
    this->Voxel.nearY = this->Voxel.nearX + room;
    this->Voxel.nearNumber = this->Voxel.nearY + room;
    this->Voxel.count = options.perVoxel;
    this->Voxel.sortedOut = 1u << 1 | 1u << 3 | 1u << 7 | 1u << 15;
    for (int rank = 0; rank < VoxelFill::MostStipples; ++rank)
    {
      this->Sight[static_cast<std::size_t>(rank)] = sight / std::sqrt(static_cast<float>(rank + 1));
    }
  }

  /// Fills the voxels of a layer whose class has the rank `order`.
  void fillLayer(int z, int order)
  {
    const SampleBox& box = this->Voxels.box;
    const auto parity =
      static_cast<int>(std::find(grayOrder.begin(), grayOrder.end(), order) - grayOrder.begin());
    this->findEarlier(parity);
    for (int y = box.begin.y; y < box.end.y; ++y)
    {
      if (((this->Geometry.first().y + y) & 1) == (parity >> 1 & 1))
      {
        this->fillRow(y, z, parity & 1);
      }
    }
  }

private:
  /// The voxels of a row that may be in the neighborhood.
  struct Row
  {
    std::size_t at = 0;
    std::size_t end = 0;
  };

  /// The neighbors of a class's voxels that are filled before them.
  void findEarlier(int parity)
  {
    for (int n = 0; n < 27; ++n)
    {
      const glm::ivec3 offset(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
      this->Earlier[n] = grayOrder[parity ^ parityClass(offset)] < grayOrder[parity];
    }
  }

  std::size_t rowIndex(int y, int z) const
  {
    const SampleBox& box = this->Voxels.box;
    return static_cast<std::size_t>(y - box.begin.y) +
      static_cast<std::size_t>(box.size().y) * static_cast<std::size_t>(z - box.begin.z);
  }

  void fillRow(int y, int z, int parity)
  {
    const SampleBox& box = this->Voxels.box;
    std::array<Row, 9> rows;
    for (int n = 0; n < 9; ++n)
    {
      const int rowY = y + n % 3 - 1;
      const int rowZ = z + n / 3 - 1;
      if (rowY >= box.begin.y && rowY < box.end.y && rowZ >= box.begin.z && rowZ < box.end.z)
      {
        const std::size_t row = this->rowIndex(rowY, rowZ);
        rows[n] = { this->Voxels.rows[row], this->Voxels.rows[row + 1] };
      }
    }
    const std::size_t row = this->rowIndex(y, z);
    for (std::size_t voxel = this->Voxels.rows[row]; voxel < this->Voxels.rows[row + 1]; ++voxel)
    {
      const int x = this->Voxels.x[voxel];
      if (((this->Geometry.first().x + x) & 1) == parity)
      {
        this->findNeighbors(x, rows);
        this->fillVoxel(voxel, { x, y, z });
      }
    }
  }

  void findNeighbors(int x, std::array<Row, 9>& rows)
  {
    this->Voxel.neighbors = 0;
    for (int n = 0; n < 9; ++n)
    {
      Row& row = rows[n];
      while (row.at < row.end && this->Voxels.x[row.at] < x - 1)
      {
        ++row.at;
      }
      const int dy = n % 3 - 1;
      const int dz = n / 3 - 1;
      for (std::size_t at = row.at; at < row.end && this->Voxels.x[at] <= x + 1; ++at)
      {
        const int dx = this->Voxels.x[at] - x;
        if (this->Earlier[3 * n + dx + 1])
        {
          const int neighbor = this->Voxel.neighbors++;
          this->Voxel.neighbor[neighbor] = &this->Stipples[at * this->Count].x;
          this->Voxel.offset[neighbor][0] = static_cast<float>(dx);
          this->Voxel.offset[neighbor][1] = static_cast<float>(dy);
          this->Voxel.offset[neighbor][2] = static_cast<float>(dz);
        }
      }
    }
  }

  void fillVoxel(std::size_t voxel, const glm::ivec3& sample)
  {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(this->Voxels.gradients[voxel]));
    const float reach = setPlane(normal, this->ToUnits, this->Voxel);
    for (std::size_t rank = 0; rank < this->Count; ++rank)
    {
      const float distance = reach + this->Sight[rank];
      this->Voxel.sight[rank] = distance * distance;
    }
    // The plane's normal in sample steps is along the gradient per sample step.
    const glm::vec3 normalInSteps(glm::normalize(normal * this->ToUnits));
    setCandidates(
      normalInSteps, static_cast<float>(this->Options.thickness), this->randomOf(sample), this->Voxel);
    this->Voxel.stipples = &this->Stipples[voxel * this->Count].x;
    this->Fill(this->Voxel);
  }

  std::uint64_t randomOf(const glm::ivec3& sample) const
  {
    const glm::u32vec3 global(this->Geometry.first() + sample);
    const std::uint64_t row = static_cast<std::uint64_t>(global.z) << 32 | global.y;
    return hash(this->Options.seed, row, global.x);
  }

  const GridGeometry& Geometry;
  const StippledVoxels& Voxels;
  const VolumeStippleOptions& Options;
  std::size_t Count;
  std::vector<glm::vec3>& Stipples;
  glm::dmat3 ToUnits; ///< sample steps to world units relative to the voxel's size
  std::array<bool, 27> Earlier{};
  void (*const Fill)(const VoxelFill&) = samplingKernels().fillVoxel;
  /// By rank, the distance from the voxel's outline on its plane up to which a stipple matters.
  std::array<float, VoxelFill::MostStipples> Sight;
  std::vector<float> Near;
  VoxelFill Voxel{};
};

} // namespace

std::vector<glm::vec3> placeVolumeStipples(const GridGeometry& geometry, const StippledVoxels& voxels,
  const VolumeStippleOptions& options, const Progress& progress)
{
  if (options.perVoxel < 1 || options.perVoxel > maximumStipplesPerVoxel || !(options.thickness >= 0.0))
  {
    throw std::invalid_argument("a voxel must have 1 to 64 stipples, in a layer of a thickness from 0 on");
  }
  std::vector<glm::vec3> stipples(voxels.size() * static_cast<std::size_t>(options.perVoxel));
  if (stipples.empty())
  {
    return stipples;
  }
  // The classes of even layers come first. Layers of the same parity are not neighbors.
  for (const int parity : { 0, 1 })
  {
    std::vector<int> layers;
    for (int z = voxels.box.begin.z; z < voxels.box.end.z; ++z)
    {
      if (((geometry.first().z + z) & 1) == parity)
      {
        layers.push_back(z);
      }
    }
    const auto fill = [&](std::size_t n)
    {
      VoxelFiller filler(geometry, voxels, options, stipples);
      for (int order = 4 * parity; order < 4 * parity + 4; ++order)
      {
        filler.fillLayer(layers[n], order);
      }
    };
    const Progress half = [&](double share) { return progress(0.5 * (parity + share)); };
    if (!parallelFor(layers.size(), fill, progress ? half : Progress()))
    {
      return {};
    }
  }
  return stipples;
}

} // namespace ink::stipple
