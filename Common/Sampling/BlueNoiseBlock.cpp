#include "Sampling/BlueNoiseBlock.h"

#include "Sampling/Hash.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace ink
{

namespace
{

// Of a sample's radius: the discs around parts below this are looked up once, and are all that matter to what
// is in them.
constexpr float largest = 0.6f;
// Likewise: a part below this whose corners are covered is. What may be left open lies at most so far from a
// disc.
constexpr float smallest = 0.06f;

bool contains(const glm::vec3& center, float radius, const glm::vec3& position)
{
  const glm::vec3 offset = position - center;
  return glm::dot(offset, offset) < radius * radius;
}

/// Which corners of a part a disc contains, a bit each. It is convex: all three are the whole part.
unsigned cornersIn(const glm::vec3& center, float radius, const SurfacePart& part)
{
  const auto& [a, b, c] = part.positions;
  return (contains(center, radius, a) ? 1u : 0u) | (contains(center, radius, b) ? 2u : 0u) |
    (contains(center, radius, c) ? 4u : 0u);
}

constexpr unsigned allCorners = 7;

} // namespace

float SurfacePart::reach() const
{
  const glm::vec3 center = this->middle();
  const glm::vec3 a = this->positions[0] - center;
  const glm::vec3 b = this->positions[1] - center;
  const glm::vec3 c = this->positions[2] - center;
  return std::sqrt(std::max({ glm::dot(a, a), glm::dot(b, b), glm::dot(c, c) }));
}

std::pair<SurfacePart, SurfacePart> SurfacePart::halves() const
{
  int longest = 0;
  float length = -1.0f;
  for (int e = 0; e < 3; ++e)
  {
    const glm::vec3 edge = this->positions[(e + 1) % 3] - this->positions[e];
    if (const float squared = glm::dot(edge, edge); squared > length)
    {
      length = squared;
      longest = e;
    }
  }
  const int from = longest;
  const int to = (longest + 1) % 3;
  std::pair<SurfacePart, SurfacePart> result(*this, *this);
  result.first.positions[to] = 0.5f * (this->positions[from] + this->positions[to]);
  result.first.corners[to] = 0.5f * (this->corners[from] + this->corners[to]);
  result.second.positions[from] = result.first.positions[to];
  result.second.corners[from] = result.first.corners[to];
  return result;
}

std::array<int, 6> BlueNoiseBlock::Grid::cellsIn(const glm::vec3& position, float reach) const
{
  const glm::vec3 local = position - this->origin;
  const float scale = 1.0f / this->cell;
  std::array<int, 6> range;
  for (int axis = 0; axis < 3; ++axis)
  {
    // Positive where it matters, and clamped where not.
    range[2 * axis] = std::max(static_cast<int>((local[axis] - reach) * scale), 0);
    range[2 * axis + 1] = std::min(static_cast<int>((local[axis] + reach) * scale), this->side - 1);
  }
  return range;
}

BlueNoiseBlock::BlueNoiseBlock(const TriangleMesh& mesh, const SurfaceWalk& walk, const glm::ivec3& block,
  const std::function<float(float)>& radiusOf)
  : Mesh(mesh)
  , Walk(walk)
  , RadiusOf(radiusOf)
  , Low(size * glm::vec3(block))
{
  for (int level = 0; level < levels; ++level)
  {
    Grid& grid = this->Grids[level];
    grid.cell = static_cast<float>(1 << level);
    grid.side = static_cast<int>(size) / (1 << level) + 2;
    grid.origin = this->Low - grid.cell;
  }
}

void BlueNoiseBlock::add(const BlueNoiseDart& dart)
{
  int level = 0;
  while (level + 1 < levels && dart.radius > this->Grids[level].cell)
  {
    ++level;
  }
  Grid& grid = this->Grids[level];
  const glm::ivec3 cell(glm::floor((dart.position - grid.origin) / grid.cell));
  if (glm::any(glm::lessThan(cell, glm::ivec3(0))) ||
    glm::any(glm::greaterThanEqual(cell, glm::ivec3(grid.side))))
  {
    return; // too far from the block to matter
  }
  if (grid.heads.empty())
  {
    grid.heads.assign(static_cast<std::size_t>(grid.side) * grid.side * grid.side, -1);
  }
  std::int32_t& head =
    grid.heads[(static_cast<std::size_t>(cell.z) * grid.side + cell.y) * grid.side + cell.x];
  this->Items.push_back({ dart.position, dart.radius, dart.sample.triangle, head });
  head = static_cast<std::int32_t>(this->Items.size() - 1);
}

bool BlueNoiseBlock::holds(const glm::vec3& position) const
{
  // Each place is in one block: the sides are whole multiples of a power of two.
  return glm::all(glm::greaterThanEqual(position, this->Low)) &&
    glm::all(glm::lessThan(position, this->Low + size));
}

template <class Visit>
bool BlueNoiseBlock::visitNear(
  const glm::vec3& position, float radius, float margin, const Visit& visit) const
{
  for (const Grid& grid : this->Grids)
  {
    if (grid.heads.empty())
    {
      continue;
    }
    const auto [xLow, xHigh, yLow, yHigh, zLow, zHigh] =
      grid.cellsIn(position, std::min(radius, grid.cell) + margin);
    for (int z = zLow; z <= zHigh; ++z)
    {
      for (int y = yLow; y <= yHigh; ++y)
      {
        const std::int32_t* row =
          grid.heads.data() + (static_cast<std::ptrdiff_t>(z) * grid.side + y) * grid.side;
        for (int x = xLow; x <= xHigh; ++x)
        {
          for (std::int32_t i = row[x]; i >= 0; i = this->Items[i].next)
          {
            const Item& item = this->Items[i];
            const float limit = std::min(radius, item.radius) + margin;
            const glm::vec3 offset = item.position - position;
            if (glm::dot(offset, offset) < limit * limit && visit(item, limit))
            {
              return true;
            }
          }
        }
      }
    }
  }
  return false;
}

bool BlueNoiseBlock::isCovered(const BlueNoiseDart& dart) const
{
  return this->visitNear(dart.position, dart.radius, 0.0f,
    [&](const Item& item, float limit)
    {
      return item.triangle == dart.sample.triangle ||
        this->Walk.distance(
          { dart.position, dart.sample.triangle }, { item.position, item.triangle }, limit) < limit;
    });
}

void BlueNoiseBlock::addSamples(std::span<const BlueNoiseDart> darts)
{
  for (const BlueNoiseDart& dart : darts)
  {
    this->add(dart);
  }
}

bool BlueNoiseBlock::tryDart(const BlueNoiseDart& dart)
{
  if (this->isCovered(dart))
  {
    return false;
  }
  this->Made.push_back(dart);
  this->add(dart);
  return true;
}

bool BlueNoiseBlock::findDiscs(const SurfacePart& part, float reach)
{
  this->Discs.clear();
  const glm::vec3 middle = part.middle();
  const glm::vec3& normal = this->Walk.normal(part.triangle);
  return this->visitNear(middle, part.radius, reach,
    [&](const Item& item, float limit)
    {
      Disc disc{ item.position, std::min(part.radius, item.radius) };
      if (item.triangle != part.triangle)
      {
        const float length =
          this->Walk.distance({ middle, part.triangle }, { item.position, item.triangle }, limit);
        if (!(length < limit))
        {
          return false;
        }
        // Laid into the part's plane, in its direction and at its distance along the surface.
        const glm::vec3 offset = item.position - middle;
        const glm::vec3 flat = offset - glm::dot(offset, normal) * normal;
        const float span = glm::length(flat);
        disc.position = span > 0.0f ? middle + (length / span) * flat : middle;
      }
      this->Discs.push_back(disc);
      return cornersIn(disc.position, disc.radius, part) == allCorners;
    });
}

bool BlueNoiseBlock::setRadius(SurfacePart& part) const
{
  if (!this->Mesh.hasDensity())
  {
    return true;
  }
  float densest = 0.0f;
  for (const glm::vec2& corner : part.corners)
  {
    densest = std::max(densest, densityOf(this->Mesh, { part.triangle, corner.x, corner.y }));
  }
  part.radius = densest > 0.0f ? this->RadiusOf(densest) : part.radius;
  return densest > 0.0f;
}

void BlueNoiseBlock::fillGaps(const SurfacePart& part, std::uint64_t random)
{
  if (this->isOutside(part))
  {
    return; // the other blocks'
  }
  const float reach = part.reach();
  if (reach < largest * part.radius)
  {
    if (!this->findDiscs(part, reach))
    {
      this->fillAmongDiscs(part, random);
    }
    return;
  }
  auto [first, second] = part.halves();
  if (this->setRadius(first))
  {
    this->fillGaps(first, hash(random, 0));
  }
  if (this->setRadius(second))
  {
    this->fillGaps(second, hash(random, 1));
  }
}

void BlueNoiseBlock::fillAmongDiscs(const SurfacePart& part, std::uint64_t random)
{
  // Corners in other blocks are theirs.
  unsigned outside = 0;
  for (unsigned corner = 0; corner < 3; ++corner)
  {
    outside |= this->holds(part.positions[corner]) ? 0u : 1u << corner;
  }
  unsigned covered = outside;
  for (const Disc& disc : this->Discs)
  {
    const unsigned corners = cornersIn(disc.position, disc.radius, part);
    covered |= corners;
    if (corners == allCorners)
    {
      return;
    }
  }
  const bool isSmallest = part.reach() < smallest * part.radius;
  if (covered != allCorners)
  {
    // Evenly in the part, then in the halves of its height towards the free corners; but at these themselves
    // rather than in a part of a part: corners of the mesh should have no more than their share.
    const float root = std::sqrt(unitFloat(random, 0));
    const float b1 = root * (1.0f - unitFloat(random, 1));
    const float b2 = root - b1;
    const float far = isSmallest ? 0.0f : 0.5f;
    const glm::vec2 places[4] = { { b1, b2 }, { far * b1, far * b2 }, { 1.0f - far * (b1 + b2), far * b2 },
      { far * b1, 1.0f - far * (b1 + b2) } };
    for (unsigned i = 0; i < 4; ++i)
    {
      if (i > 0 && (covered & (1u << (i - 1))))
      {
        continue;
      }
      if (this->tryInPart(part, places[i]))
      {
        const Disc& disc = this->Discs.back();
        const unsigned corners = cornersIn(disc.position, disc.radius, part);
        covered |= corners;
        if (corners == allCorners)
        {
          return;
        }
      }
    }
  }
  if (isSmallest || (outside == allCorners && this->isOutside(part)))
  {
    return;
  }
  const auto [first, second] = part.halves();
  this->fillAmongDiscs(first, hash(random, 0));
  this->fillAmongDiscs(second, hash(random, 1));
}

bool BlueNoiseBlock::isOutside(const SurfacePart& part) const
{
  const auto& [a, b, c] = part.positions;
  const glm::vec3 low = glm::min(glm::min(a, b), c);
  const glm::vec3 high = glm::max(glm::max(a, b), c);
  return glm::any(glm::lessThan(high, this->Low)) || glm::any(glm::greaterThanEqual(low, this->Low + size));
}

bool BlueNoiseBlock::tryInPart(const SurfacePart& part, const glm::vec2& place)
{
  const auto mix = [&](const auto& corners)
  { return corners[0] + place.x * (corners[1] - corners[0]) + place.y * (corners[2] - corners[0]); };
  BlueNoiseDart dart;
  dart.position = mix(part.positions);
  for (const Disc& disc : this->Discs)
  {
    if (contains(disc.position, disc.radius, dart.position))
    {
      return false;
    }
  }
  const glm::vec2 barycentric = mix(part.corners);
  dart.sample = { part.triangle, barycentric.x, barycentric.y };
  const float density = densityOf(this->Mesh, dart.sample);
  if (!(density > 0.0f) || !this->holds(dart.position))
  {
    return false;
  }
  dart.radius = this->RadiusOf(density);
  if (!this->tryDart(dart))
  {
    return false;
  }
  this->Discs.push_back({ dart.position, std::min(part.radius, dart.radius) });
  return true;
}

} // namespace ink
