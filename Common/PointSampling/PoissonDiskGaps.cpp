// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/PoissonDiskGaps.h"

#include "Core/Hash.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace ink
{

namespace
{

constexpr std::size_t mostKnown = 64;

bool contains(const PoissonDiskBins::Disc& disc, float radius, const glm::vec3& position)
{
  const glm::vec3 offset = position - disc.center;
  const float limit = std::min(radius, disc.radius);
  return glm::dot(offset, offset) < limit * limit;
}

} // namespace

PoissonDiskGaps::PoissonDiskGaps(
  const PoissonDiskBins& bins, const RadiusAt& radiusAt, float smallest, const Make& make)
  : Bins(bins)
  , Radius(radiusAt)
  , Smallest(smallest)
  , MakeSample(make)
{
}

void PoissonDiskGaps::fill(const PoissonDiskBins::Open& bin, std::uint64_t random)
{
  if (!this->Bins.isOpen(bin))
  {
    return;
  }
  this->Triangle = bin.triangle;
  this->Bins.listDiscs(bin, this->Discs);
  const PoissonDiskBins::Outline outline = this->Bins.outline(bin);
  for (int i = 2; i < outline.count; ++i)
  {
    const auto corner = [&](int index) {
      return Corner{ outline.corners[index], outline.barycentric[index], 0 };
    };
    this->fill({ corner(0), corner(i - 1), corner(i) }, 0, hash(random, static_cast<std::uint64_t>(i)));
  }
}

void PoissonDiskGaps::findDiscs(Corner& corner, std::size_t first, float radius) const
{
  for (std::size_t i = first; i < std::min(this->Discs.size(), mostKnown); ++i)
  {
    corner.discs |= contains(this->Discs[i], radius, corner.position) ? std::uint64_t(1) << i : 0;
  }
}

void PoissonDiskGaps::fill(Part part, std::size_t known, std::uint64_t random)
{
  float radius = this->Radius ? 0.0f : 1.0f;
  if (this->Radius)
  {
    // The density is linear, so its maximum is at a corner.
    for (const Corner& corner : part)
    {
      const float own = this->Radius({ this->Triangle, corner.barycentric.x, corner.barycentric.y });
      radius = radius > 0.0f && own > 0.0f ? std::min(radius, own) : std::max(radius, own);
    }
    if (!(radius > 0.0f))
    {
      return;
    }
  }
  // A disc is convex: if it contains all corners, it contains the whole part.
  const auto isCovered = [&] { return (part[0].discs & part[1].discs & part[2].discs) != 0; };
  const auto catchUp = [&]
  {
    for (Corner& corner : part)
    {
      this->findDiscs(corner, known, radius);
    }
    known = this->Discs.size();
  };
  catchUp();
  if (isCovered())
  {
    return;
  }
  std::size_t longest = 0;
  float length = -1.0f;
  for (std::size_t e = 0; e < 3; ++e)
  {
    const glm::vec3 edge = part[e == 2 ? 0 : e + 1].position - part[e].position;
    if (const float squared = glm::dot(edge, edge); squared > length)
    {
      length = squared;
      longest = e;
    }
  }
  // A part extends from its center by about six tenths of its longest edge.
  const bool isSmallest = 0.36f * length < this->Smallest * this->Smallest * radius * radius;
  const bool isFree[3] = { part[0].discs == 0, part[1].discs == 0, part[2].discs == 0 };
  if (isFree[0] || isFree[1] || isFree[2])
  {
    // First at a random position in the part, then at random in the half near each uncovered corner, not at
    // the corner itself: otherwise corners of the mesh would get too many samples. The smallest parts try the
    // corner.
    const float root = std::sqrt(unitFloat(random, 0));
    const float b1 = root * (1.0f - unitFloat(random, 1));
    const float b2 = root - b1;
    const float far = isSmallest ? 0.0f : 0.5f;
    const glm::vec2 candidates[4] = { { b1, b2 }, { far * b1, far * b2 },
      { 1.0f - far * (b1 + b2), far * b2 }, { far * b1, 1.0f - far * (b1 + b2) } };
    for (std::size_t i = 0; i < 4; ++i)
    {
      if ((i == 0 || (part[i - 1].discs == 0)) && this->tryAt(part, candidates[i]))
      {
        catchUp();
        if (isCovered())
        {
          return;
        }
      }
    }
  }
  if (isSmallest)
  {
    return;
  }
  const std::size_t to = longest == 2 ? 0 : longest + 1;
  Corner middle{ 0.5f * (part[longest].position + part[to].position),
    0.5f * (part[longest].barycentric + part[to].barycentric), 0 };
  this->findDiscs(middle, 0, radius);
  Part half = part;
  half[to] = middle;
  this->fill(half, known, hash(random, 0));
  half = part;
  half[longest] = middle;
  this->fill(half, known, hash(random, 1));
}

bool PoissonDiskGaps::tryAt(const Part& part, const glm::vec2& weights)
{
  const auto mix = [&](const auto member)
  {
    return part[0].*member + weights.x * (part[1].*member - part[0].*member) +
      weights.y * (part[2].*member - part[0].*member);
  };
  PoissonDiskDart dart;
  const glm::vec2 barycentric = mix(&Corner::barycentric);
  dart.sample = { this->Triangle, barycentric.x, barycentric.y };
  dart.position = mix(&Corner::position);
  dart.radius = this->Radius ? this->Radius(dart.sample) : 1.0f;
  if (!(dart.radius > 0.0f))
  {
    return false;
  }
  for (const PoissonDiskBins::Disc& disc : this->Discs)
  {
    if (contains(disc, dart.radius, dart.position))
    {
      return false;
    }
  }
  this->MakeSample(dart);
  this->Discs.push_back({ dart.position, dart.radius, 0 });
  return true;
}

} // namespace ink
