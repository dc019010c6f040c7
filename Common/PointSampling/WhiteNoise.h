// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// White-noise samples of a mesh: independent, uniform by area or, with a density, by area times density.
///
/// A sample's triangle is found in the cumulative areas, and its position in it is P = (1 - sqrt(r1)) A +
/// sqrt(r1)(1 - r2) B + sqrt(r1) r2 C (Osada et al. 2002, section 3.1, equation 1). Instead of a search per
/// sample, the samples are generated in sorted order as sums of exponential spacings, which are distributed
/// like sorted uniform numbers. So samples are sorted by triangle, and memory is traversed once.
/// @param areas those of cumulateArea(mesh)
/// @param seed random choices hash it with the sample's index
/// @return `count` samples; none if the mesh has no area or density, or when stopped
std::vector<SurfaceSample> sampleWhiteNoise(const TriangleMesh& mesh, const CumulativeArea& areas,
  std::size_t count, std::uint64_t seed, const Progress& progress = {});

/// White-noise samples of a mesh that may be a piece of a larger one: uniform in each triangle, their number
/// proportional to its area and rounded up or down at random. A triangle's samples depend only on the
/// triangle, so all pieces together have the samples of the whole.
/// @param ids an id per triangle that does not depend on the piece it is in
/// @param perArea samples per unit area
/// @param seed random choices hash it with the triangle's id and the sample's index in the triangle
/// @return the samples, sorted by triangle; none when stopped
std::vector<SurfaceSample> sampleWhiteNoise(const TriangleMesh& mesh, std::span<const std::uint64_t> ids,
  double perArea, std::uint64_t seed, const Progress& progress = {});

/// A random position in a triangle: uniform, or by the density at its points if there is one.
SurfaceSample placeInTriangle(const TriangleMesh& mesh, std::uint32_t triangle, std::uint64_t random);

/// The triangle in which the cumulative weight reaches `sum`: never one without weight.
/// @param sums CumulativeArea::weights()
/// @param sum in [0, last sum)
inline std::uint32_t findTriangle(std::span<const double> sums, double sum)
{
  return static_cast<std::uint32_t>(std::upper_bound(sums.begin(), sums.end(), sum) - sums.begin() - 1);
}

/// The same, if it is known not to be before `triangle`.
inline std::uint32_t findTriangle(std::span<const double> sums, double sum, std::uint32_t triangle)
{
  while (sums[triangle + 1] <= sum)
  {
    ++triangle;
  }
  return triangle;
}

} // namespace ink
