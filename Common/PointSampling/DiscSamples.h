// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// Enough for cubic cells, and for discs of other origin; longer cells need more, see isoSurfaceSampleReach.
inline constexpr float reachOfCubes = 0.82f;

/// Points of a surface with the discs around them that cover it, as an iso-surface's samples or a scan have
/// them. All spans have one element per point.
struct SurfaceDiscs
{
  /// Relative to their center, so that single precision suffices.
  std::span<const glm::vec3> centers;
  std::span<const glm::vec3> normals; ///< unit
  /// In the unit of the centers: discs of these radii leave no holes. Those that are not positive and finite
  /// are left out, as are discs without a finite center and normal.
  std::span<const float> radii;
  /// Of the surface that each stands for, above 0, in the unit of the centers; empty: areaOfDisc.
  std::span<const float> areas{};
  /// The share of the radii within which samples lie, 0 to 1: enough to leave no holes between the discs of
  /// neighbors, and no more, as positions near a rim lie farther off the surface.
  float reach = reachOfCubes;
};

/// A position on a disc.
struct DiscSample
{
  glm::vec3 position; ///< in the frame of the centers
  glm::vec3 normal;   ///< unit: the disc's
  std::uint32_t disc;
};

/// An estimate of the area that a disc stands for, among others that overlap as much as it takes to leave no
/// holes: its squared radius.
inline double areaOfDisc(double radius)
{
  return radius * radius;
}

/// The same of all discs together.
double areaOf(const SurfaceDiscs& discs);

/// The distance of samples that has room for about so many on discs.
double spacingForCount(const SurfaceDiscs& discs, double count, double candidates);

/// The area of the surface per sample of sampleDiscs, whatever the discs.
double areaPerSample(double spacing, double candidates);

/// Blue-noise samples of the surface that discs cover, down to a distance between neighbors, in progressive
/// order: the counterpart of sampleProgressively for surfaces without triangles. Candidates lie anywhere on
/// the discs, so that samples may be denser than the points, and do not show their pattern. They lie off the
/// surface by at most its curvature times half the square of a radius.
///
/// A disc's candidates depend on where it is alone: on a cube, and its rank among those in it. A cube's edge
/// is the greatest power of two up to the largest radius (more for surfaces that are 2^19 radii wide). So a
/// surface that changes a little keeps most of its samples, but where the edge changes.
/// @param spacing the least distance of neighbors, in the unit of the centers, above 0
/// @param candidates per sample, see sampleProgressively
/// @param seed random choices hash it with the disc's cube and rank, not with its index: their order does not
///   matter
/// @return the samples; none when stopped
/// @throws std::invalid_argument if the surface is wider than 2^24 times the spacing
std::vector<DiscSample> sampleDiscs(const SurfaceDiscs& discs, double spacing, double candidates,
  std::uint64_t seed, const Progress& progress = {});

} // namespace ink
