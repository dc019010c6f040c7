#pragma once

#include "Parallel/ParallelFor.h"
#include "Sampling/TriangleMesh.h"

#include <cstdint>
#include <vector>

namespace ink
{

/// Independent samples of a mesh, evenly by area or, with a density, by area times density: white noise.
///
/// A sample's triangle is found in the cumulative areas and its place in it by
/// P = (1 - sqrt(r1)) A + sqrt(r1)(1 - r2) B + sqrt(r1) r2 C (Osada et al. 2002, section 3.1, eq. 1). Instead
/// of searching the areas for each sample, the samples are drawn sorted: sums of exponential spacings, which
/// are distributed as sorted uniform numbers are. So they come in the order of their triangles, and memory is
/// walked through once.
/// @param areas those of cumulateArea(mesh)
/// @param seed together with the sample's index all that the choice depends on
/// @return `count` samples, or none when nothing of the mesh has an area and a density, or when stopped
std::vector<SurfaceSample> sampleWhiteNoise(const TriangleMesh& mesh, const CumulativeArea& areas,
  std::size_t count, std::uint64_t seed, const Progress& progress = {});

} // namespace ink
