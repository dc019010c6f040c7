// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/ParallelFor.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ink
{

/// Loops over many elements in chunks of a fixed size, so that what is put together from the chunks, in their
/// order, is the same for any number of threads, sums of rounded numbers included.
inline constexpr std::size_t elementsPerChunk = 1 << 14;

constexpr std::size_t chunksOf(std::size_t count)
{
  return (count + elementsPerChunk - 1) / elementsPerChunk;
}

/// Calls body(chunk, begin, end) for each chunk of the elements 0 ... count - 1, in any order.
template <class Body>
void parallelForChunks(std::size_t count, const Body& body)
{
  parallelFor(chunksOf(count),
    [&](std::size_t chunk)
    {
      const std::size_t begin = chunk * elementsPerChunk;
      body(chunk, begin, std::min(begin + elementsPerChunk, count));
    });
}

/// join(... join(join(start, of(0)), of(1)) ..., of(count - 1)), each chunk on its own first.
/// @param start what changes nothing, 0 of a sum say
template <class Value, class Of, class Join>
Value parallelReduce(std::size_t count, const Value& start, const Of& of, const Join& join)
{
  std::vector<Value> parts(chunksOf(count), start);
  parallelForChunks(count,
    [&](std::size_t chunk, std::size_t begin, std::size_t end)
    {
      Value part = start;
      for (std::size_t i = begin; i < end; ++i)
      {
        part = join(part, of(i));
      }
      parts[chunk] = part;
    });
  Value all = start;
  for (const Value& part : parts)
  {
    all = join(all, part);
  }
  return all;
}

/// Those of 0 ... count - 1 that pass a test, ascending.
/// @param count at most 2^32
template <class Test>
std::vector<std::uint32_t> parallelSelect(std::size_t count, const Test& passes)
{
  std::vector<std::vector<std::uint32_t>> selected(chunksOf(count));
  parallelForChunks(count,
    [&](std::size_t chunk, std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        if (passes(i))
        {
          selected[chunk].push_back(static_cast<std::uint32_t>(i));
        }
      }
    });
  std::size_t size = 0;
  for (const std::vector<std::uint32_t>& some : selected)
  {
    size += some.size();
  }
  std::vector<std::uint32_t> all;
  all.reserve(size);
  for (const std::vector<std::uint32_t>& some : selected)
  {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

} // namespace ink
