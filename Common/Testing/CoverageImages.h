// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "HashNoise.h"
#include "Raster/CoverageImage.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

namespace ink::testing
{

/// A small drawing that owns its pixels.
struct Picture
{
  int width = 0;
  int height = 0;
  std::vector<unsigned char> pixels;

  Picture(int w, int h, unsigned char value = 0)
    : width(w)
    , height(h)
    , pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), value)
  {
  }

  /// From rows of characters, the lowest row first: '.' no ink, '#' full ink, a digit d: 25 d.
  explicit Picture(const std::vector<std::string>& rows)
    : Picture(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()))
  {
    for (int y = 0; y < this->height; ++y)
    {
      for (int x = 0; x < this->width; ++x)
      {
        const char c = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
        this->at(x, y) = static_cast<unsigned char>(c == '#' ? 255 : c == '.' ? 0 : 25 * (c - '0'));
      }
    }
  }

  unsigned char& at(int x, int y) { return this->pixels[static_cast<std::size_t>(y * this->width + x)]; }
  unsigned char at(int x, int y) const { return this->pixels[static_cast<std::size_t>(y * this->width + x)]; }
  bool isIn(int x, int y) const { return x >= 0 && y >= 0 && x < this->width && y < this->height; }

  raster::CoverageImage image() { return { this->pixels, this->width, this->height }; }

  /// Full ink wherever a condition on the coordinates holds.
  template <class Condition>
  Picture& draw(const Condition& condition)
  {
    for (int y = 0; y < this->height; ++y)
    {
      for (int x = 0; x < this->width; ++x)
      {
        this->at(x, y) = condition(x, y) ? 255 : this->at(x, y);
      }
    }
    return *this;
  }

  Picture mirrored() const
  {
    Picture result(this->width, this->height);
    for (int y = 0; y < this->height; ++y)
    {
      for (int x = 0; x < this->width; ++x)
      {
        result.at(x, y) = this->at(this->width - 1 - x, this->height - 1 - y);
      }
    }
    return result;
  }

  std::ptrdiff_t inkCount() const
  {
    return std::count_if(this->pixels.begin(), this->pixels.end(), [](unsigned char v) { return v != 0; });
  }

  bool operator==(const Picture&) const = default;
};

inline void PrintTo(const Picture& picture, std::ostream* out)
{
  *out << picture.width << " x " << picture.height;
  for (int y = 0; y < picture.height && picture.pixels.size() < 10000; ++y)
  {
    *out << '\n';
    for (int x = 0; x < picture.width; ++x)
    {
      const int value = picture.at(x, y);
      *out << (value == 0 ? '.' : value == 255 ? '#' : static_cast<char>('0' + std::min(9, value / 25)));
    }
  }
}

/// The pieces of ink (or of none) that hang together by sides, or also by corners.
inline int countPieces(const Picture& picture, bool ofInk, bool byCorners)
{
  // A border of emptiness, so that all that is outside is one piece.
  const int width = picture.width + 2;
  const int height = picture.height + 2;
  std::vector<bool> isOne(static_cast<std::size_t>(width * height), !ofInk);
  for (int y = 0; y < picture.height; ++y)
  {
    for (int x = 0; x < picture.width; ++x)
    {
      isOne[static_cast<std::size_t>((y + 1) * width + x + 1)] = (picture.at(x, y) != 0) == ofInk;
    }
  }
  int pieces = 0;
  std::vector<int> open;
  for (int start = 0; start < width * height; ++start)
  {
    if (!isOne[static_cast<std::size_t>(start)])
    {
      continue;
    }
    ++pieces;
    isOne[static_cast<std::size_t>(start)] = false;
    open.push_back(start);
    while (!open.empty())
    {
      const int x = open.back() % width;
      const int y = open.back() / width;
      open.pop_back();
      for (int dy = -1; dy <= 1; ++dy)
      {
        for (int dx = -1; dx <= 1; ++dx)
        {
          const int i = (y + dy) * width + x + dx;
          if ((byCorners || dx == 0 || dy == 0) && x + dx >= 0 && x + dx < width && y + dy >= 0 &&
            y + dy < height && isOne[static_cast<std::size_t>(i)])
          {
            isOne[static_cast<std::size_t>(i)] = false;
            open.push_back(i);
          }
        }
      }
    }
  }
  return pieces;
}

inline int countSpots(const Picture& picture)
{
  return countPieces(picture, true, true);
}

inline int countHoles(const Picture& picture)
{
  return countPieces(picture, false, false) - 1;
}

/// Ink of random darkness on a share of the pixels.
inline Picture randomPicture(int width, int height, double share, std::uint64_t seed)
{
  Picture picture(width, height);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
  {
    const double value = hashUniform(seed, i);
    picture.pixels[i] = value < share ? static_cast<unsigned char>(1 + 254 * value / share) : 0;
  }
  return picture;
}

/// Lines like those of a drawing: where waves of random directions cancel each other, `width` pixels wide.
inline Picture randomLines(int width, int height, double lineWidth, std::uint64_t seed)
{
  Picture picture(width, height);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      double sum = 0.0;
      double across = 0.0;
      double along = 0.0;
      for (std::uint64_t wave = 0; wave < 6; ++wave)
      {
        const double angle = 6.283185307179586 * hashUniform(seed, 2 * wave);
        const double frequency = 0.1;
        const double phase = frequency * (std::cos(angle) * x + std::sin(angle) * y) +
          6.283185307179586 * hashUniform(seed, 2 * wave + 1);
        sum += std::sin(phase);
        across += frequency * std::cos(angle) * std::cos(phase);
        along += frequency * std::sin(angle) * std::cos(phase);
      }
      const double distance = std::abs(sum) / std::max(1e-9, std::hypot(across, along));
      picture.at(x, y) =
        static_cast<unsigned char>(255.0 * std::clamp(0.5 * lineWidth + 0.5 - distance, 0.0, 1.0));
    }
  }
  return picture;
}

} // namespace ink::testing
