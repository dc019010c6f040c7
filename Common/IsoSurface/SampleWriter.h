// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "IsoSurface/IsoSurfaceSamples.h"
#include "Simd/SamplingKernels.h"

#include <cstddef>
#include <limits>
#include <type_traits>

/// Writes batches of samples to the output arrays. Internal to Common/IsoSurface.
namespace ink
{

/// The output arrays, advanced by `samples`.
inline SampleRoom roomAfter(const SampleRoom& room, std::size_t samples)
{
  const auto move = [samples](auto* p) { return p ? p + 3 * samples : p; };
  return { move(room.points), move(room.doublePoints), move(room.normals), move(room.shortNormals),
    move(room.byteNormals), room.capacity, room.cells ? room.cells + samples : nullptr };
}

template <class Work, class To>
void writePoints(const Work (&points)[3][BatchStride], int count, To* to)
{
  for (int i = 0; i < count; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      to[3 * i + axis] = static_cast<To>(points[axis][i]);
    }
  }
}

/// A unit vector's component times the largest Integer, rounded.
template <class Integer>
Integer quantized(float component)
{
  const float v = component * std::numeric_limits<Integer>::max();
  return static_cast<Integer>(v + (v < 0.0f ? -0.5f : 0.5f));
}

template <class Integer>
void writeQuantized(const float (&normals)[3][BatchStride], int count, Integer* to)
{
  for (int i = 0; i < count; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      to[3 * i + axis] = quantized<Integer>(normals[axis][i]);
    }
  }
}

/// Writes the first `count` samples of a batch.
template <class Work>
void writeSamples(
  const SamplingKernels& kernels, const CellBatch<Work>& batch, int count, const SampleRoom& to)
{
  if (to.doublePoints)
  {
    writePoints(batch.points, count, to.doublePoints);
  }
  else if constexpr (std::is_same_v<Work, float>)
  {
    kernels.interleave(batch.points[0], batch.points[1], batch.points[2], count, to.points);
  }
  else
  {
    writePoints(batch.points, count, to.points);
  }
  if (to.normals)
  {
    kernels.interleave(batch.normals[0], batch.normals[1], batch.normals[2], count, to.normals);
  }
  if (to.shortNormals)
  {
    writeQuantized(batch.normals, count, to.shortNormals);
  }
  if (to.byteNormals)
  {
    writeQuantized(batch.normals, count, to.byteNormals);
  }
}

} // namespace ink
