// SPDX-License-Identifier: BSD-3-Clause
#include "Raster/Thin.h"

#include "Core/ParallelChunks.h"
#include "Core/ParallelFor.h"
#include "Raster/RowScan.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace ink::raster
{

namespace
{

constexpr std::size_t pixelsPerTask = 4096;
constexpr int rowsPerTask = 64;

/// The neighbors of a pixel in a circle, as bits: right, upper right, above, ..., lower right.
constexpr unsigned right = 1;
constexpr unsigned above = 4;
constexpr unsigned left = 16;
constexpr unsigned below = 64;
constexpr std::array<unsigned, 4> sides = { above, below, left, right };

/// Whether a pixel with these neighbors can be removed: it has more than one, so it does not end a line, and
/// it is simple: its neighbors form one component of ink and one empty component.
constexpr bool canGo(unsigned neighbors)
{
  if (std::popcount(neighbors) < 2)
  {
    return false;
  }
  // The crossing number: transitions from empty to ink around the pixel; a corner between two inked sides
  // connects them.
  int pieces = 0;
  for (unsigned side = 0; side < 8; side += 2)
  {
    const bool here = neighbors >> side & 1;
    const bool corner = neighbors >> (side + 1) & 1;
    const bool next = neighbors >> (side + 2) % 8 & 1;
    pieces += !here && (corner || next) ? 1 : 0;
  }
  return pieces == 1;
}

constexpr std::array<bool, 256> makeCanGo()
{
  std::array<bool, 256> table = {};
  for (unsigned neighbors = 0; neighbors < 256; ++neighbors)
  {
    table[neighbors] = canGo(neighbors);
  }
  return table;
}

constexpr std::array<bool, 256> canGoOf = makeCanGo();

/// The ink of an image as flags, with an empty border.
class Ink
{
public:
  Ink(const CoverageImage& image, unsigned char threshold);

  /// Removes one layer; returns false if nothing was removed.
  bool peel();
  bool isInk(int x, int y) const { return this->Flags[this->indexOf(x, y)] & inky; }

private:
  static constexpr unsigned char inky = 1;
  static constexpr unsigned char due = 2; // in the list of the next layer

  std::size_t indexOf(int x, int y) const
  {
    return static_cast<std::size_t>(y + 1) * this->Stride + static_cast<std::size_t>(x + 1);
  }

  unsigned neighborsOf(std::size_t pixel) const
  {
    const unsigned char* const p = this->Flags.data() + pixel;
    const auto stride = static_cast<std::ptrdiff_t>(this->Stride);
    const auto bit = [&](std::ptrdiff_t offset, int n) { return (p[offset] & 1u) << n; };
    return bit(1, 0) | bit(stride + 1, 1) | bit(stride, 2) | bit(stride - 1, 3) | bit(-1, 4) |
      bit(-stride - 1, 5) | bit(-stride, 6) | bit(1 - stride, 7);
  }

  /// Removes the removable pixels of the layer that are empty on one side.
  void takeFrom(unsigned side);

  std::size_t Stride;
  std::vector<unsigned char> Flags;
  std::vector<std::size_t> Layer; // pixels that may be removable
  std::vector<std::size_t> Gone;
  std::vector<std::size_t> Next;
  std::vector<std::vector<std::size_t>> Found; // of each task
};

Ink::Ink(const CoverageImage& image, unsigned char threshold)
  : Stride(static_cast<std::size_t>(image.width) + 2)
  , Flags(this->Stride * (static_cast<std::size_t>(image.height) + 2), 0)
{
  const auto tasks = static_cast<std::size_t>((image.height + rowsPerTask - 1) / rowsPerTask);
  const auto forRows = [&](const auto& body)
  {
    parallelFor(tasks,
      [&](std::size_t task)
      {
        const int begin = static_cast<int>(task) * rowsPerTask;
        for (int y = begin; y < std::min(begin + rowsPerTask, image.height); ++y)
        {
          const unsigned char* const row = image.row(y);
          for (int x = skipEmpty(row, 0, image.width); x < image.width;
               x = skipEmpty(row, x + 1, image.width))
          {
            body(task, row[x], this->indexOf(x, y));
          }
        }
      });
  };
  forRows([&](std::size_t, unsigned char value, std::size_t pixel)
    { this->Flags[pixel] = value >= threshold ? inky : 0; });
  this->Found.resize(tasks);
  forRows(
    [&](std::size_t task, unsigned char, std::size_t pixel)
    {
      if ((this->Flags[pixel] & inky) && this->neighborsOf(pixel) != 255)
      {
        this->Found[task].push_back(pixel);
      }
    });
  for (const std::vector<std::size_t>& found : this->Found)
  {
    this->Layer.insert(this->Layer.end(), found.begin(), found.end());
  }
}

void Ink::takeFrom(unsigned side)
{
  const std::size_t tasks = chunksOf(this->Layer.size(), pixelsPerTask);
  this->Found.resize(std::max(tasks, this->Found.size()));
  parallelForChunks(
    this->Layer.size(),
    [&](std::size_t task, std::size_t begin, std::size_t end)
    {
      std::vector<std::size_t>& found = this->Found[task];
      found.clear();
      for (std::size_t i = begin; i < end; ++i)
      {
        const std::size_t pixel = this->Layer[i];
        if (this->Flags[pixel] & inky)
        {
          const unsigned neighbors = this->neighborsOf(pixel);
          if (!(neighbors & side) && canGoOf[neighbors])
          {
            found.push_back(pixel);
          }
        }
      }
    },
    pixelsPerTask);
  for (std::size_t task = 0; task < tasks; ++task)
  {
    for (const std::size_t pixel : this->Found[task])
    {
      this->Flags[pixel] = 0;
    }
    this->Gone.insert(this->Gone.end(), this->Found[task].begin(), this->Found[task].end());
  }
}

bool Ink::peel()
{
  this->Gone.clear();
  for (const unsigned side : sides)
  {
    this->takeFrom(side);
  }
  // Pixels can only become removable next to removed ones.
  this->Next.clear();
  const auto stride = static_cast<std::ptrdiff_t>(this->Stride);
  for (const std::size_t pixel : this->Gone)
  {
    for (const std::ptrdiff_t row : { -stride, std::ptrdiff_t(0), stride })
    {
      for (const std::ptrdiff_t column : { -1, 0, 1 })
      {
        const std::size_t near = pixel + static_cast<std::size_t>(row + column);
        if (this->Flags[near] == inky)
        {
          this->Flags[near] |= due;
          this->Next.push_back(near);
        }
      }
    }
  }
  for (const std::size_t pixel : this->Next)
  {
    this->Flags[pixel] &= static_cast<unsigned char>(~due);
  }
  std::swap(this->Layer, this->Next);
  return !this->Layer.empty();
}

} // namespace

void thin(const CoverageImage& image, unsigned char threshold)
{
  image.check();
  if (image.pixels.empty())
  {
    return;
  }
  Ink layers(image, std::max<unsigned char>(threshold, 1));
  while (layers.peel())
  {
  }
  const auto tasks = static_cast<std::size_t>((image.height + rowsPerTask - 1) / rowsPerTask);
  parallelFor(tasks,
    [&](std::size_t task)
    {
      const int begin = static_cast<int>(task) * rowsPerTask;
      for (int y = begin; y < std::min(begin + rowsPerTask, image.height); ++y)
      {
        unsigned char* const row = image.row(y);
        for (int x = skipEmpty(row, 0, image.width); x < image.width; x = skipEmpty(row, x + 1, image.width))
        {
          row[x] = layers.isInk(x, y) ? row[x] : 0;
        }
      }
    });
}

} // namespace ink::raster
