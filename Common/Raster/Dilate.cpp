// SPDX-License-Identifier: BSD-3-Clause
#include "Raster/Dilate.h"

#include "Core/ParallelFor.h"
#include "Raster/RowScan.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace ink::raster
{

namespace
{

constexpr int dilatedRowsPerTask = 32;

/// The structuring element: the weights of a pixel's ink at others, in 1/256, one row of weights per row
/// distance.
struct Stamp
{
  struct Row
  {
    int reach; // weights -reach ... reach are not 0
    std::vector<std::uint16_t> weights;
  };
  std::vector<Row> rows; // of distance 0, 1, ...

  explicit Stamp(double radius)
  {
    for (int dy = 0; dy < radius + 1.0; ++dy)
    {
      Row row{ -1, {} };
      for (int dx = 0; dx < radius + 1.0; ++dx)
      {
        const double weight = std::clamp(radius + 1.0 - std::hypot(dx, dy), 0.0, 1.0);
        row.weights.push_back(static_cast<std::uint16_t>(std::lround(256.0 * weight)));
        row.reach = row.weights.back() > 0 ? dx : row.reach;
      }
      const int count = row.reach + 1;
      row.weights.resize(static_cast<std::size_t>(count));
      // Mirrored to the left of the center.
      std::vector<std::uint16_t> whole(row.weights.rbegin(), row.weights.rend());
      whole.insert(whole.end(), row.weights.begin() + (row.weights.empty() ? 0 : 1), row.weights.end());
      row.weights = std::move(whole);
      this->rows.push_back(std::move(row));
    }
  }
};

/// Whether a pixel is surrounded by neighbors with at least as much ink. Then it can be skipped: in every
/// direction a neighbor contributes at least as much.
bool isInside(const CoverageImage& image, int x, int y)
{
  const unsigned char value = image.row(y)[x];
  for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, image.height - 1); ++ny)
  {
    const unsigned char* const row = image.row(ny);
    for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, image.width - 1); ++nx)
    {
      if (row[nx] < value)
      {
        return false;
      }
    }
  }
  return true;
}

void stampRow(unsigned char* target, int width, int x, unsigned value, const Stamp::Row& row)
{
  const int begin = std::max(x - row.reach, 0);
  const int end = std::min(x + row.reach + 1, width);
  const std::uint16_t* const weights = row.weights.data() + (begin - x + row.reach);
  for (int i = begin; i < end; ++i)
  {
    const auto ink = static_cast<unsigned char>(value * weights[i - begin] >> 8);
    target[i] = std::max(target[i], ink);
  }
}

/// The maximum ink within a radius of each pixel.
void widen(const CoverageImage& image, double radius)
{
  const Stamp stamp(radius);
  const int reach = static_cast<int>(stamp.rows.size()) - 1;
  std::vector<unsigned char> before(image.pixels.begin(), image.pixels.end());
  const CoverageImage source{ before, image.width, image.height };
  parallelFor(static_cast<std::size_t>((image.height + dilatedRowsPerTask - 1) / dilatedRowsPerTask),
    [&](std::size_t task)
    {
      const int begin = static_cast<int>(task) * dilatedRowsPerTask;
      const int end = std::min(begin + dilatedRowsPerTask, image.height);
      for (int y = std::max(begin - reach, 0); y < std::min(end + reach, image.height); ++y)
      {
        const unsigned char* const row = source.row(y);
        for (int x = skipEmpty(row, 0, image.width); x < image.width; x = skipEmpty(row, x + 1, image.width))
        {
          if (isInside(source, x, y))
          {
            continue;
          }
          for (int to = std::max(begin, y - reach); to < std::min(end, y + reach + 1); ++to)
          {
            stampRow(
              image.row(to), image.width, x, row[x], stamp.rows[static_cast<std::size_t>(std::abs(to - y))]);
          }
        }
      }
    });
}

} // namespace

void dilate(const CoverageImage& image, float radius)
{
  image.check();
  const double distance = std::min(std::abs(radius), mostLineGrowth);
  if (image.pixels.empty() || !(distance > 0.0))
  {
    return;
  }
  const auto invert = [&]
  {
    for (unsigned char& pixel : image.pixels)
    {
      pixel = static_cast<unsigned char>(255 - pixel);
    }
  };
  if (radius < 0.0f)
  {
    invert();
  }
  widen(image, distance);
  if (radius < 0.0f)
  {
    invert();
  }
}

} // namespace ink::raster
