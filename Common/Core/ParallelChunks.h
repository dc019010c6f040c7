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
/// order, is the same for any number of threads, sums of rounded numbers included. Fewer elements per chunk
/// are for those that are much work each.
inline constexpr std::size_t elementsPerChunk = 1 << 14;

constexpr std::size_t chunksOf(std::size_t count, std::size_t perChunk = elementsPerChunk)
{
  return (count + perChunk - 1) / perChunk;
}

/// Calls body(chunk, begin, end) for each chunk of the elements 0 ... count - 1, in any order.
/// @return false when `progress` asked to stop; then some chunks were skipped.
template <class Body>
bool parallelForChunks(
  std::size_t count, const Body& body, std::size_t perChunk = elementsPerChunk, const Progress& progress = {})
{
  return parallelFor(
    chunksOf(count, perChunk),
    [&](std::size_t chunk)
    {
      const std::size_t begin = chunk * perChunk;
      body(chunk, begin, std::min(begin + perChunk, count));
    },
    progress);
}

/// Calls body(i) for each of the elements 0 ... count - 1, in any order.
/// @return false when `progress` asked to stop; then some were skipped.
template <class Body>
bool parallelForEach(
  std::size_t count, const Body& body, std::size_t perChunk = elementsPerChunk, const Progress& progress = {})
{
  return parallelForChunks(
    count,
    [&](std::size_t, std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        body(i);
      }
    },
    perChunk, progress);
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

/// What add(i, found) appends to a vector `found`, for i = 0 ... count - 1, in the order of i.
/// @return nothing when `progress` asked to stop
template <class Value, class Add>
std::vector<Value> parallelGather(
  std::size_t count, const Add& add, std::size_t perChunk = elementsPerChunk, const Progress& progress = {})
{
  std::vector<std::vector<Value>> parts(chunksOf(count, perChunk));
  const bool finished = parallelForChunks(
    count,
    [&](std::size_t chunk, std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        add(i, parts[chunk]);
      }
    },
    perChunk, progress);
  if (!finished)
  {
    return {};
  }
  std::size_t size = 0;
  for (const std::vector<Value>& part : parts)
  {
    size += part.size();
  }
  std::vector<Value> all;
  all.reserve(size);
  for (const std::vector<Value>& part : parts)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

/// Those of 0 ... count - 1 that pass a test, ascending.
/// @param count at most 2^32
template <class Test>
std::vector<std::uint32_t> parallelSelect(
  std::size_t count, const Test& passes, std::size_t perChunk = elementsPerChunk)
{
  return parallelGather<std::uint32_t>(
    count,
    [&](std::size_t i, std::vector<std::uint32_t>& found)
    {
      if (passes(i))
      {
        found.push_back(static_cast<std::uint32_t>(i));
      }
    },
    perChunk);
}

} // namespace ink
