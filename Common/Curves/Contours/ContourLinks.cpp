// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/ContourLinks.h"

#include "Core/KeyNumbers.h"
#include "Curves/Contours/BrickSamples.h"

#include <algorithm>
#include <utility>

namespace ink
{
namespace
{

/// What stands in place of the next segment where a chain ends: the number of the last point. And in place of
/// that of a segment which a chain has.
constexpr ContourLinks::Id EndsAt = ContourLinks::Id(1) << 63;
constexpr ContourLinks::Id Taken = ContourLinks::none - 1;

std::uint64_t faceInGrid(const GridGeometry& geometry, const CellBrick& brick, int face)
{
  const glm::ivec3 sample = brick.first + BrickSamples::sampleOf(face / ContourFace::shapes);
  return geometry.offset(sample) << 4 | static_cast<std::uint64_t>(face % ContourFace::shapes);
}

} // namespace

void ContourLinks::add(std::size_t part, const GridGeometry& geometry, const CellBrick& brick,
  const BrickSegments& found, std::span<std::uint32_t> begins)
{
  const Id first = static_cast<Id>(part) << 32;
  // What is in the table of bricks before is no larger than this.
  const auto before = static_cast<std::uint32_t>(this->segments.size());
  const std::span<const BrickSegment> some(found.segments.data(), static_cast<std::size_t>(found.count));
  for (std::uint32_t n = 0; n < some.size(); ++n)
  {
    begins[some[n].beginFace] = before + n + 1;
  }
  this->segments.resize(before + some.size());
  Segment* const added = this->segments.data() + before;
  const glm::ivec3 cells = geometry.dimensions() - 1;
  for (std::uint32_t n = 0; n < some.size(); ++n)
  {
    const glm::ivec3 cell = brick.first + CellBrick::cell(some[n].cell);
    added[n] = { geometry.toWorld(
                   glm::dvec3(geometry.first() + cell) + some[n].begin - glm::dvec3(geometry.first())),
      cell.x + cells.x * (cell.y + static_cast<std::int64_t>(cells.y) * cell.z), none, none };
  }
  for (std::uint32_t n = 0; n < some.size(); ++n)
  {
    const std::uint32_t next = begins[some[n].endFace];
    if (next > before)
    {
      added[n].next = first | (next - 1);
      this->segments[next - 1].previous = first | (before + n);
    }
    else
    {
      this->openEnds.push_back({ faceInGrid(geometry, brick, some[n].endFace), before + n });
    }
  }
  for (std::uint32_t n = 0; n < some.size(); ++n)
  {
    if (added[n].previous == none)
    {
      this->openBegins.push_back({ faceInGrid(geometry, brick, some[n].beginFace), before + n });
    }
  }
}

Contours joinContour(
  std::span<ContourLinks> parts, const std::function<glm::dvec3(std::uint64_t face)>& nodeOf)
{
  using Id = ContourLinks::Id;
  const auto segmentOf = [&](Id id) -> ContourLinks::Segment&
  { return parts[id >> 32].segments[id & 0xffffffff]; };
  const auto idOf = [](std::size_t part, std::uint32_t segment)
  { return static_cast<Id>(part) << 32 | segment; };

  std::size_t segmentCount = 0;
  std::size_t openCount = 0;
  for (const ContourLinks& part : parts)
  {
    segmentCount += part.segments.size();
    openCount += part.openBegins.size() + part.openEnds.size();
  }
  KeyNumbers faces(openCount);
  std::vector<Id> begins; // by the face's number: no other segment begins there
  for (std::size_t part = 0; part < parts.size(); ++part)
  {
    for (const ContourLinks::OpenEnd& open : parts[part].openBegins)
    {
      faces.numberOf(open.face);
      begins.push_back(idOf(part, open.segment));
    }
  }
  std::vector<glm::dvec3> lastPoints;
  for (std::size_t part = 0; part < parts.size(); ++part)
  {
    for (const ContourLinks::OpenEnd& open : parts[part].openEnds)
    {
      const Id id = idOf(part, open.segment);
      const std::uint32_t number = faces.numberOf(open.face);
      if (number < begins.size())
      {
        segmentOf(id).next = begins[number];
        segmentOf(begins[number]).previous = id;
      }
      else
      {
        segmentOf(id).next = EndsAt | lastPoints.size();
        lastPoints.push_back(nodeOf(open.face));
      }
    }
  }

  Contours contours;
  contours.positions.reserve(segmentCount);
  contours.elements.reserve(segmentCount);
  const auto take = [&contours](ContourLinks::Segment& segment)
  {
    contours.positions.push_back(segment.begin);
    contours.elements.push_back(segment.cell);
    return std::exchange(segment.next, Taken);
  };
  for (std::size_t part = 0; part < parts.size(); ++part)
  {
    for (std::uint32_t n = 0; n < parts[part].segments.size(); ++n)
    {
      ContourLinks::Segment& first = parts[part].segments[n];
      if (first.next == Taken)
      {
        continue;
      }
      const auto begin = static_cast<std::ptrdiff_t>(contours.positions.size());
      Id next = take(first);
      while (next != idOf(part, n) && (next & EndsAt) == 0)
      {
        next = take(segmentOf(next));
      }
      const bool closed = (next & EndsAt) == 0;
      if (!closed)
      {
        // What leads to the first segment, from there back, and then to where it belongs.
        const auto middle = static_cast<std::ptrdiff_t>(contours.positions.size());
        for (Id id = first.previous; id != ContourLinks::none;)
        {
          ContourLinks::Segment& segment = segmentOf(id);
          id = segment.previous;
          take(segment);
        }
        const auto toFront = [&](auto& values)
        {
          std::reverse(values.begin() + middle, values.end());
          std::rotate(values.begin() + begin, values.begin() + middle, values.end());
        };
        toFront(contours.positions);
        toFront(contours.elements);
        contours.positions.push_back(lastPoints[next & ~EndsAt]);
        contours.elements.push_back(contours.elements.back());
      }
      contours.chains.offsets.push_back(contours.positions.size());
      contours.chains.closed.push_back(closed);
      contours.kinds.push_back(ContourKind::Silhouette);
    }
  }
  return contours;
}

} // namespace ink
