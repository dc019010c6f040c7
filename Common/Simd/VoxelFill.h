// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace ink
{

/// A voxel to be filled with stipples, and what its stipples keep away from. See placeVolumeStipples and
/// SamplingKernels::fillVoxel. Plain data, as everything that crosses the borders of instruction sets.
struct VoxelFill
{
  /// Rows of numbers by rank are readable and writable up to a multiple of this.
  static constexpr int Lanes = 8;
  static constexpr int MostNeighbors = 26;
  static constexpr int MostStipples = 64;

  /// The stipples to place.
  int count;
  /// The stipples of the neighbors that are filled already: x, y, z of each in turn, from its own sample;
  /// readable for `count` stipples. Where that sample lies from here.
  int neighbors;
  const float* neighbor[MostNeighbors];
  float offset[MostNeighbors][3];

  /// Take sample steps to two axes on the tangent plane, in units of the voxel's size.
  float planeX[3];
  float planeY[3];
  /// By rank: the square of the distance from the sample on the plane up to which stipples count.
  float sight[MostStipples];
  /// At these ranks the stipples beyond that distance are removed: not at each, as that takes time, too.
  std::uint64_t sortedOut;

  /// The voxel's positions between the planes p1 and p2: the axis nearest to the normal, `solved`, follows
  /// from the other two (solved + 1) % 3 and (solved + 2) % 3 by the slopes, up to a part of `height`.
  int solved;
  float slope[2];
  float height;
  /// Where the sequences of candidates start.
  std::uint32_t start[3];

  /// Room for the stipples that count: 27 count + 2 Lanes numbers each.
  float* nearX;
  float* nearY;
  float* nearNumber;

  /// Out: x, y, z of each stipple in turn, from the sample, in sample steps.
  float* stipples;
};

} // namespace ink
