// SPDX-License-Identifier: BSD-3-Clause
#include "Tiles.h"

#include <algorithm>

namespace ink::cli
{
namespace
{

int roundUp(int value, int factor)
{
  return (value + factor - 1) / factor * factor;
}

std::vector<Tiles::Strip> cut(int length, int window, int overlap)
{
  const int step = window - 2 * overlap;
  std::vector<Tiles::Strip> strips;
  for (int first = 0; first < length; first += step)
  {
    strips.push_back({ first, std::min(step, length - first), overlap });
  }
  return strips;
}

} // namespace

Tiles::Tiles(int width, int height, int longest, int overlap, int factor)
  : Height(height)
  , WindowWidth(width)
  , WindowHeight(height)
{
  if (std::max(width, height) <= longest)
  {
    this->Columns = { { 0, width, 0 } };
    this->Rows = { { 0, height, 0 } };
    return;
  }
  // With a scale of one mappers would take a tile for a whole picture.
  this->Scale = std::max((height + longest - 1) / longest, 2);
  this->WindowHeight = roundUp((height + this->Scale - 1) / this->Scale, factor);
  this->WindowWidth = roundUp(std::min(width, longest), factor);
  // Of a small window something has to be left.
  const int most = std::min(this->WindowWidth, this->WindowHeight) / 4 / factor * factor;
  overlap = std::min(roundUp(overlap, factor), most);
  this->Columns = cut(width, this->WindowWidth, overlap);
  this->Rows = cut(height, this->WindowHeight, overlap);
}

} // namespace ink::cli
