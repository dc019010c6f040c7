// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// Candidates per sample: more give more even samples and take longer. The default, and the range.
inline constexpr double defaultCandidates = 8.0;
inline constexpr double leastCandidates = 2.0;
inline constexpr double mostCandidates = 64.0;

/// The number of samples that keep a radius on a flat surface, times radius^2 / area.
double progressiveCount(double candidates);

/// A given number of blue-noise samples, generated in progressive order: for every k, the first k have a
/// minimum distance that falls with k, and leave no voids much larger than it.
///
/// As in progressiveOrder, this is dart throwing with a radius that shrinks by a twelfth of an octave at a
/// time (McCool and Fiume 1992, section 3); but each octave draws new random candidates, a few per expected
/// sample. So the time of each octave is proportional to its own samples, and the total is 4/3 that of the
/// last. Space is divided into blocks of eight colors, and an octave's blocks of one color are processed in
/// parallel: the samples do not depend on the number of threads. Two samples of the same octave are apart by
/// the smaller of their radii, so that blocks need not synchronize at each radius.
///
/// Several times as fast as samplePoissonDiskCount, but less even: voids are as large as those between
/// candidates. Sides and sheets of a surface are distinguished by their normals, see areApart; unlike there,
/// parallel sheets that face the same way and are closer than the samples' distance share their samples.
/// @param mesh without a density
/// @param areas those of cumulateArea(mesh)
/// @param normals one per point of the mesh, which orient the triangles consistently; empty: orientation by
///   the order of their corners
/// @param candidates clamped to [leastCandidates, mostCandidates]
/// @param seed random choices hash it with positions on the mesh
/// @return `count` samples in progressive order; fewer if they are so crowded that single precision cannot
///   tell them apart; none when stopped, or if the mesh has no area
/// @throws std::invalid_argument if the mesh is wider than 2^24 times the samples' distance
std::vector<SurfaceSample> sampleProgressively(const TriangleMesh& mesh, const CumulativeArea& areas,
  std::span<const glm::vec3> normals, std::size_t count, double candidates, std::uint64_t seed,
  const Progress& progress = {});

} // namespace ink
