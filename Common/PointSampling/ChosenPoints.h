// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/MortonOrder.h"

#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

/// Internal to Common/PointSampling.
namespace ink
{

inline constexpr std::uint32_t noPoint = ~0u;

/// What progressiveOrder chooses from: positions are from 0 to 1.
struct DartPoint
{
  glm::vec3 position;
  glm::vec3 normal; // 0: unknown
  float radius;     // at most 1
};

/// A grid of cells with the points chosen in each.
class ChosenPoints
{
public:
  ChosenPoints(std::span<const DartPoint> points, std::span<const std::uint64_t> mortonCodes)
    : Points(points)
    , MortonCodes(mortonCodes)
    , CellOf(points.size())
    , Next(points.size(), noPoint)
  {
  }

  /// Sets the cells' width to 2^(1 - octave) and sorts the chosen points into them.
  /// @param isDone(point) whether its distance will not be queried any more
  template <class IsDone>
  void setOctave(int octave, std::span<const std::uint32_t> chosen, const IsDone& isDone);

  /// The distance from a point to the nearest chosen one, in units of the smaller of the two radii; infinite
  /// if it is not below `width`, which is at most that of the cells.
  float distance(std::uint32_t index, float width) const;

  void add(std::uint32_t point)
  {
    std::uint32_t& head = this->Heads[this->CellOf[point]];
    this->Next[point] = head;
    head = point;
  }

  /// The block of four cells along each axis that contains a point; its lowest bits are its color. Blocks of
  /// one color are far enough apart to add points to them concurrently.
  std::uint64_t blockOf(std::uint32_t point) const { return this->MortonCodes[point] >> this->Shift >> 6; }
  static constexpr std::uint64_t colors = 8;

private:
  void findNeighbors(const std::vector<bool>& wanted);

  std::span<const DartPoint> Points;
  std::span<const std::uint64_t> MortonCodes;
  int Shift = 0;
  float Width = 2.0f;
  std::vector<std::uint32_t> CellOf; // of each point
  std::vector<std::uint64_t> Cells;  // occupied cells, in Morton order
  std::vector<std::uint32_t> Heads;  // of each cell: one chosen point,
  std::vector<std::uint32_t> Next;   // and of each point another
  // For each cell, the occupied ones of the 27 around it, and which of the 27 they are.
  std::vector<std::uint32_t> Begin;
  std::vector<std::uint32_t> Neighbors;
  std::vector<std::uint8_t> Directions;
};

template <class IsDone>
void ChosenPoints::setOctave(int octave, std::span<const std::uint32_t> chosen, const IsDone& isDone)
{
  this->Shift = 3 * (mortonBits - octave);
  this->Width = std::ldexp(2.0f, -octave);
  this->Cells.clear();
  std::vector<bool> wanted;
  for (std::uint32_t i = 0; i < this->MortonCodes.size(); ++i)
  {
    const std::uint64_t cell = this->MortonCodes[i] >> this->Shift;
    if (this->Cells.empty() || this->Cells.back() != cell)
    {
      this->Cells.push_back(cell);
      wanted.push_back(false);
    }
    wanted.back() = wanted.back() || !isDone(i);
    this->CellOf[i] = static_cast<std::uint32_t>(this->Cells.size() - 1);
  }
  this->findNeighbors(wanted);
  this->Heads.assign(this->Cells.size(), noPoint);
  for (const std::uint32_t point : chosen)
  {
    this->add(point);
  }
}

} // namespace ink
