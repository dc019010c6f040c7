#pragma once

#include "Parallel/ParallelFor.h"
#include "Sampling/TriangleMesh.h"

#include <algorithm>
#include <cstdint>
#include <span>
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

/// Independent samples of a mesh that may be a piece of another: as many in each triangle as its area takes,
/// rounded up or down at random, evenly. A triangle's samples depend on nothing but itself: those of all
/// pieces together are the whole's.
/// @param names one a triangle, the same for it in whatever piece
/// @param perArea how many samples an area of 1 has
/// @param seed together with the triangle's name and the sample's index in it all that the choice depends on
/// @return the samples in the order of their triangles; none when stopped
std::vector<SurfaceSample> sampleWhiteNoise(const TriangleMesh& mesh, std::span<const std::uint64_t> names,
  double perArea, std::uint64_t seed, const Progress& progress = {});

/// A random place in a triangle: evenly, or by the density at its points where there is one.
SurfaceSample placeInTriangle(const TriangleMesh& mesh, std::uint32_t triangle, std::uint64_t random);

/// The triangle in which a sum over the triangles' weights reaches `place`: never one of no weight.
/// @param sums CumulativeArea::weights()
/// @param place from 0 to below the last sum
inline std::uint32_t findTriangle(std::span<const double> sums, double place)
{
  return static_cast<std::uint32_t>(std::upper_bound(sums.begin(), sums.end(), place) - sums.begin() - 1);
}

/// The same for a place that is not before `triangle`.
inline std::uint32_t findTriangle(std::span<const double> sums, double place, std::uint32_t triangle)
{
  while (sums[triangle + 1] <= place)
  {
    ++triangle;
  }
  return triangle;
}

} // namespace ink
