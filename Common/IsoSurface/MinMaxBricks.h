// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Simd/SamplingKernels.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace ink
{

/// The minimum and maximum of each brick of a grid's samples: 32 x 4 x 4 samples for types of one and two
/// bytes, 16 x 4 x 4 for larger ones, so that the memory is at most 1/128 of the volume's. findActiveCells
/// fills it as a by-product and then, for another iso-value, reads only bricks that the surface enters.
class MinMaxBricks
{
public:
  /// Whether the ranges are complete, and for a grid of this size and type.
  template <class T>
  bool fits(const glm::ivec3& samples) const
  {
    return this->Complete && this->Samples == samples && this->ElementSize == sizeof(T);
  }
  void clear() { *this = MinMaxBricks(); }
  std::size_t bytes() const { return this->Low.capacity() + this->High.capacity(); }

  /// Allocates the ranges of a grid; they are complete after setComplete().
  template <class T>
  void start(const glm::ivec3& samples)
  {
    this->Complete = false;
    this->Samples = samples;
    this->ElementSize = sizeof(T);
    this->Counts = { (samples.x + BrickLength<T> - 1) / BrickLength<T>,
      (samples.y + BrickWidth - 1) / BrickWidth, (samples.z + BrickWidth - 1) / BrickWidth };
    const std::size_t count = static_cast<std::size_t>(this->Counts.x) * this->Counts.y * this->Counts.z;
    this->Low.resize(count * sizeof(T));
    this->High.resize(count * sizeof(T));
  }
  void setComplete() { this->Complete = true; }

  /// Bricks along each axis.
  const glm::ivec3& counts() const { return this->Counts; }
  /// The ranges of a row of bricks.
  template <class T>
  T* low(int j, int k)
  {
    return reinterpret_cast<T*>(this->Low.data()) + this->rowOf(j, k);
  }
  template <class T>
  T* high(int j, int k)
  {
    return reinterpret_cast<T*>(this->High.data()) + this->rowOf(j, k);
  }

private:
  std::size_t rowOf(int j, int k) const
  {
    return static_cast<std::size_t>(this->Counts.x) * (j + static_cast<std::size_t>(this->Counts.y) * k);
  }

  bool Complete = false;
  std::size_t ElementSize = 0;
  glm::ivec3 Samples = glm::ivec3(0);
  glm::ivec3 Counts = glm::ivec3(0);
  std::vector<std::byte> Low;
  std::vector<std::byte> High;
};

} // namespace ink
