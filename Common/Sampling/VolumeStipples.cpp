#include "Sampling/VolumeStipples.h"

#include "Sampling/Hash.h"
#include "Sampling/StippleCrowd.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace ink
{
namespace
{

using Lanes = StippleCrowd::Lanes;
constexpr int lanes = StippleCrowd::lanes;

/// Stipples farther away than this, in units of the root of the area that a stipple has, do not matter: where
/// a surface is one voxel thick, a place lies hardly farther than that from the next stipple.
constexpr float sight = 0.65f;

/// The place of a parity class (x + 2 y + 4 z) in Gray code order 000 001 011 010 110 111 101 100.
constexpr std::array<int, 8> grayOrder{ 0, 1, 3, 2, 7, 6, 4, 5 };

int parityClass(const glm::ivec3& global)
{
  return (global.x & 1) | (global.y & 1) << 1 | (global.z & 1) << 2;
}

/// The places of a voxel between the planes, from which the stipples are chosen.
class Candidates
{
public:
  /// \param normal of the planes, unit, in sample steps
  /// \param thickness of the layer between the planes, in sample steps
  Candidates(const glm::vec3& normal, float thickness, std::uint64_t random)
    : StartA(static_cast<std::uint32_t>(random))
    , StartB(static_cast<std::uint32_t>(random >> 32))
    , StartC(static_cast<std::uint32_t>(hash(random)))
  {
    // The axis nearest to the normal is solved for, the others are free.
    const glm::vec3 size = glm::abs(normal);
    this->C = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    this->A = (this->C + 1) % 3;
    this->B = (this->C + 2) % 3;
    const float inverse = 1.0f / normal[this->C];
    this->SlopeA = normal[this->A] * inverse;
    this->SlopeB = normal[this->B] * inverse;
    // The voxel's corners are as far apart along the normal.
    this->Height = std::min(thickness, size.x + size.y + size.z) * inverse;
  }

  /// The next ones.
  void next()
  {
    // The additive recurrence with the powers of 1 / 1.2207440846, which fills the cube evenly from the first
    // point on (Roberts 2018). Whole numbers do not round.
    Lanes a;
    Lanes b;
    Lanes c;
    for (int i = 0; i < lanes; ++i)
    {
      const std::uint32_t n = this->Made + static_cast<std::uint32_t>(i);
      a[i] = centred(this->StartA + n * 3518319155u);
      b[i] = centred(this->StartB + n * 2882110345u);
      c[i] =
        this->Height * centred(this->StartC + n * 2360945575u) - this->SlopeA * a[i] - this->SlopeB * b[i];
    }
    this->Made += lanes;
    this->Position[this->A] = a;
    this->Position[this->B] = b;
    this->Position[this->C] = c;
  }

  /// In sample steps, by axis.
  const std::array<Lanes, 3>& positions() const { return this->Position; }
  bool isInside(int i) const { return std::abs(this->Position[this->C][i]) <= 0.5f; }

private:
  /// All of the numbers to [-1/2, 1/2].
  static float centred(std::uint32_t bits)
  {
    return static_cast<float>(static_cast<std::int32_t>(bits)) * 0x1p-32f;
  }

  std::array<Lanes, 3> Position{};
  int A;
  int B;
  int C;
  float SlopeA;
  float SlopeB;
  float Height;
  std::uint32_t StartA;
  std::uint32_t StartB;
  std::uint32_t StartC;
  std::uint32_t Made = 0;
};

/// Takes places in a voxel to its tangent plane.
class Projection
{
public:
  /// \param normal of the plane, unit
  /// \param toUnits takes sample steps to the unit of lengths on the plane
  Projection(const glm::dvec3& normal, const glm::dmat3& toUnits)
  {
    // Duff et al. 2017, listing 3.
    const double sign = std::copysign(1.0, normal.z);
    const double a = -1.0 / (sign + normal.z);
    const double b = normal.x * normal.y * a;
    this->X = glm::dvec3(1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x) * toUnits;
    this->Y = glm::dvec3(b, sign + normal.y * normal.y * a, -normal.y) * toUnits;
    const glm::vec3 x = glm::abs(this->X);
    const glm::vec3 y = glm::abs(this->Y);
    this->Reach = 0.5f * glm::length(glm::vec2(x.x + x.y + x.z, y.x + y.y + y.z));
  }

  glm::vec2 operator()(const glm::vec3& step) const
  {
    return { this->X.x * step.x + this->X.y * step.y + this->X.z * step.z,
      this->Y.x * step.x + this->Y.y * step.y + this->Y.z * step.z };
  }

  /// At least as far as the voxel's corners lie from its middle.
  float reach() const { return this->Reach; }

private:
  glm::vec3 X;
  glm::vec3 Y;
  float Reach;
};

/// Fills voxels, one after the other; one such object for each thread's work.
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
    , Near(27 * Count + 1)
  {
    const glm::dmat3& steps = geometry.stepToWorld();
    this->ToUnits = steps * (1.0 / std::cbrt(std::abs(glm::determinant(steps))));
  }

  /// Fills the voxels of a layer whose class comes at `order`.
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
  /// The voxels of a row that may still be near.
  struct Row
  {
    std::size_t at = 0;
    std::size_t end = 0;
  };
  struct Neighbour
  {
    const glm::vec3* stipples;
    glm::vec3 offset; ///< in sample steps
  };

  /// Which neighbours of a class's voxels are filled before them.
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
        this->findNeighbours(x, rows);
        this->fillVoxel(voxel, { x, y, z });
      }
    }
  }

  void findNeighbours(int x, std::array<Row, 9>& rows)
  {
    this->NeighbourCount = 0;
    for (int n = 0; n < 9; ++n)
    {
      Row& row = rows[n];
      while (row.at < row.end && this->Voxels.x[row.at] < x - 1)
      {
        ++row.at;
      }
      for (std::size_t at = row.at; at < row.end && this->Voxels.x[at] <= x + 1; ++at)
      {
        const int dx = this->Voxels.x[at] - x;
        if (this->Earlier[3 * n + dx + 1])
        {
          this->Neighbours[this->NeighbourCount++] = { &this->Stipples[at * this->Count],
            glm::vec3(dx, n % 3 - 1, n / 3 - 1) };
        }
      }
    }
  }

  void fillVoxel(std::size_t voxel, const glm::ivec3& sample)
  {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(this->Voxels.gradients[voxel]));
    const Projection toPlane(normal, this->ToUnits);
    const auto sightAt = [&toPlane](int number)
    { return toPlane.reach() + sight / std::sqrt(static_cast<float>(number)); };

    this->Near.clear();
    for (int rank = 0; rank < this->Options.perVoxel; ++rank)
    {
      const float distance = sightAt(rank + 1);
      for (int n = 0; n < this->NeighbourCount; ++n)
      {
        const glm::vec2 place = toPlane(this->Neighbours[n].offset + this->Neighbours[n].stipples[rank]);
        this->Near.addIf(glm::dot(place, place) <= distance * distance, place.x, place.y, rank + 1);
      }
    }

    // The plane's normal in sample steps is along the gradient per sample step.
    const glm::vec3 normalInSteps(glm::normalize(normal * this->ToUnits));
    Candidates candidates(normalInSteps, static_cast<float>(this->Options.thickness), this->randomOf(sample));
    for (int rank = 0; rank < this->Options.perVoxel; ++rank)
    {
      // Not each time, because it takes a while, too.
      if (rank == 1 || rank == 3 || rank == 7 || rank == 15)
      {
        this->Near.keepWithin(sightAt(rank + 1));
      }
      const glm::vec3 chosen = this->chooseCandidate(candidates, toPlane, rank);
      this->Stipples[voxel * this->Count + static_cast<std::size_t>(rank)] = chosen;
      const glm::vec2 place = toPlane(chosen);
      this->Near.addIf(true, place.x, place.y, rank + 1);
    }
  }

  std::uint64_t randomOf(const glm::ivec3& sample) const
  {
    const glm::u32vec3 global(this->Geometry.first() + sample);
    const std::uint64_t row = static_cast<std::uint64_t>(global.z) << 32 | global.y;
    return hash(this->Options.seed, row, global.x);
  }

  /// The one whose nearest stipple is farthest.
  glm::vec3 chooseCandidate(Candidates& candidates, const Projection& toPlane, int rank)
  {
    glm::vec3 chosen(0.0f);
    float widest = -1.0f;
    // Hardly ever are all of them outside. In a thin layer at a voxel's corner the middle is then as good.
    for (int tries = 0; tries < 4 && widest < 0.0f; ++tries)
    {
      candidates.next();
      const auto& [a, b, c] = candidates.positions();
      Lanes x;
      Lanes y;
      for (int i = 0; i < lanes; ++i)
      {
        const glm::vec2 place = toPlane({ a[i], b[i], c[i] });
        x[i] = place.x;
        y[i] = place.y;
      }
      Lanes spacing;
      this->Near.leastSpacing(x, y, rank + 1, spacing);
      for (int i = 0; i < lanes; ++i)
      {
        if (candidates.isInside(i) && spacing[i] > widest)
        {
          widest = spacing[i];
          chosen = { a[i], b[i], c[i] };
        }
      }
    }
    return chosen;
  }

  const GridGeometry& Geometry;
  const StippledVoxels& Voxels;
  const VolumeStippleOptions& Options;
  std::size_t Count;
  std::vector<glm::vec3>& Stipples;
  glm::dmat3 ToUnits; ///< sample steps to world units relative to the voxel's size
  std::array<bool, 27> Earlier{};
  std::array<Neighbour, 26> Neighbours;
  int NeighbourCount = 0;
  StippleCrowd Near;
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
  // The classes of even layers come first. Layers of the same parity are not each other's neighbours.
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

} // namespace ink
