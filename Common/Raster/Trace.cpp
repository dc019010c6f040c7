// SPDX-License-Identifier: BSD-3-Clause
#include "Raster/Trace.h"

#include "Raster/RowScan.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace ink::raster
{

namespace
{

/// The eight neighbors in a circle; the opposite of direction d is (d + 4) % 8.
constexpr std::array<glm::ivec2, 8> steps = { glm::ivec2(1, 0), glm::ivec2(1, 1), glm::ivec2(0, 1),
  glm::ivec2(-1, 1), glm::ivec2(-1, 0), glm::ivec2(-1, -1), glm::ivec2(0, -1), glm::ivec2(1, -1) };

/// The steps from each pixel to others that have not been traced yet, as bits.
class Ways
{
public:
  explicit Ways(const CoverageImage& image);

  /// Follows a line from a pixel in a direction up to its end.
  TracedLine follow(glm::ivec2 pixel, int direction);

  unsigned char all(glm::ivec2 pixel) const { return this->All[this->indexOf(pixel)]; }
  unsigned char left(glm::ivec2 pixel) const { return this->Left[this->indexOf(pixel)]; }

private:
  std::size_t indexOf(glm::ivec2 pixel) const
  {
    return static_cast<std::size_t>(pixel.y) * this->Width + static_cast<std::size_t>(pixel.x);
  }

  std::size_t Width;
  std::vector<unsigned char> All;
  std::vector<unsigned char> Left;
};

Ways::Ways(const CoverageImage& image)
  : Width(static_cast<std::size_t>(image.width))
  , All(image.pixels.size(), 0)
{
  const auto hasInk = [&](glm::ivec2 p)
  { return p.x >= 0 && p.y >= 0 && p.x < image.width && p.y < image.height && image.row(p.y)[p.x] != 0; };
  for (int y = 0; y < image.height; ++y)
  {
    const unsigned char* const row = image.row(y);
    for (int x = skipEmpty(row, 0, image.width); x < image.width; x = skipEmpty(row, x + 1, image.width))
    {
      unsigned ways = 0;
      for (unsigned d = 0; d < 8; ++d)
      {
        ways |= hasInk(glm::ivec2(x, y) + steps[d]) ? 1u << d : 0u;
      }
      for (unsigned d = 1; d < 8; d += 2)
      {
        if (ways >> (d - 1) & 1 || ways >> (d + 1) % 8 & 1)
        {
          ways &= ~(1u << d);
        }
      }
      this->All[this->indexOf({ x, y })] = static_cast<unsigned char>(ways);
    }
  }
  this->Left = this->All;
}

TracedLine Ways::follow(glm::ivec2 pixel, int direction)
{
  const glm::ivec2 first = pixel;
  TracedLine line{ pixel };
  while (true)
  {
    this->Left[this->indexOf(pixel)] &= static_cast<unsigned char>(~(1u << direction));
    pixel += steps[static_cast<std::size_t>(direction)];
    this->Left[this->indexOf(pixel)] &= static_cast<unsigned char>(~(1u << (direction + 4) % 8));
    line.push_back(pixel);
    if (pixel == first || std::popcount(this->all(pixel)) != 2)
    {
      return line;
    }
    direction = std::countr_zero(this->left(pixel));
  }
}

} // namespace

std::vector<TracedLine> trace(const CoverageImage& thinned)
{
  thinned.check();
  Ways ways(thinned);
  std::vector<TracedLine> lines;
  const auto forInk = [&](const auto& body)
  {
    for (int y = 0; y < thinned.height; ++y)
    {
      const unsigned char* const row = thinned.row(y);
      for (int x = skipEmpty(row, 0, thinned.width); x < thinned.width;
           x = skipEmpty(row, x + 1, thinned.width))
      {
        body(glm::ivec2(x, y));
      }
    }
  };
  forInk(
    [&](glm::ivec2 pixel)
    {
      const int meeting = std::popcount(ways.all(pixel));
      if (meeting == 0)
      {
        lines.push_back({ pixel });
      }
      while (meeting != 2 && ways.left(pixel) != 0)
      {
        lines.push_back(ways.follow(pixel, std::countr_zero(ways.left(pixel))));
      }
    });
  // The remaining lines have neither ends nor junctions.
  forInk(
    [&](glm::ivec2 pixel)
    {
      if (ways.left(pixel) != 0)
      {
        lines.push_back(ways.follow(pixel, std::countr_zero(ways.left(pixel))));
      }
    });
  return lines;
}

std::vector<float> lengthsAlong(const TracedLine& line)
{
  std::vector<float> lengths(line.size(), 0.0f);
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i)
  {
    const glm::ivec2 step = line[i] - line[i - 1];
    length += std::hypot(step.x, step.y);
    lengths[i] = static_cast<float>(length);
  }
  return lengths;
}

} // namespace ink::raster
