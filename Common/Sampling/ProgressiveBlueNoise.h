// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Parallel/ParallelFor.h"
#include "Sampling/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// Candidates for each sample: the more, the more even the samples, and the longer it takes. They can be
/// chosen within these.
inline constexpr double defaultCandidates = 8.0;
inline constexpr double leastCandidates = 2.0;
inline constexpr double mostCandidates = 64.0;

/// How many samples keep a radius on a flat surface: this times area / radius^2.
double progressiveCount(double candidates);

/// A number of blue-noise samples, placed in the order of their priorities: the first k are nowhere nearer to
/// each other than a distance that falls with k, and leave no gaps much larger than it.
///
/// As in priorityOrder, darts are thrown with a radius that shrinks by a twelfth of an octave at a time
/// (McCool and Fiume 1992, section 3); but for each octave at new random places, a few for each sample that
/// is expected. So each octave takes a time in proportion to its own samples, and all of them that of the
/// last and a third. An octave's darts are thrown block by block of space, blocks of one of eight colors in
/// parallel: the samples do not depend on the number of threads. A sample of one radius keeps away from
/// another of the same octave by the smaller of the two, so that blocks need not wait for each other at each
/// radius.
///
/// Samples are several times as fast as those of sampleBlueNoiseCount, and less even: gaps are as wide as no
/// candidate fell into. Sides and sheets of a surface are told apart by their normals, see areApart: unlike
/// there, sheets that face the same way and lie nearer to each other than samples share their samples.
/// @param mesh without a density
/// @param areas those of cumulateArea(mesh)
/// @param normals one a point of the mesh, that say which sides of triangles are alike; or none: then the
///   order of their corners does
/// @param candidates brought between leastCandidates and mostCandidates
/// @param seed together with places on the mesh all that the choice depends on
/// @return `count` samples, the most important first; fewer where they are so crowded that single precision
///   does not tell them apart; none when stopped, or when nothing of the mesh has an area
/// @throw std::invalid_argument if the mesh is more than 2^24 distances between samples wide
std::vector<SurfaceSample> sampleProgressively(const TriangleMesh& mesh, const CumulativeArea& areas,
  std::span<const glm::vec3> normals, std::size_t count, double candidates, std::uint64_t seed,
  const Progress& progress = {});

} // namespace ink
