// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <cstdint>
#include <vector>

namespace ink
{

/// Poisson-disk samples: no two are closer along the surface than a radius, and there is hardly room for
/// another.
struct PoissonDisk
{
  std::vector<SurfaceSample> samples;
  /// The Poisson-disk radius, with a density that at the mean density, see LocalRadius. In the mesh's unit.
  double radius = 0.0;
  bool stopped = false;
};

/// The number of samples of a saturated random sampling is this times area / radius^2: half-radius discs then
/// cover .547 of the area, the jamming limit of random sequential adsorption (Feder 1980).
inline constexpr double saturatedCount = 0.547 * 4.0 / 3.14159265358979;

/// The distance between neighbors of `count` points in a hexagonal lattice, the largest minimum distance in
/// the plane: sqrt(2 area / (sqrt(3) count)).
double hexagonalDistance(double area, double count);

/// The density-dependent radius at a position on the mesh: radius / sqrt(density / mean density), at most
/// sixteen times the smallest.
class LocalRadius
{
public:
  LocalRadius(const TriangleMesh& mesh, const CumulativeArea& areas, double radius);
  double least() const { return this->Least; }
  double most() const { return this->Most; }
  /// Between least() and 16 times that.
  double at(float density) const;

private:
  bool Constant;
  double Scale; // radius at density 1
  double Least;
  double Most;
};

/// Coverage slack: every position has a sample within (1 + slack) times the radius. The default, and the
/// range; the default is nearly as fast as any larger value.
inline constexpr double defaultCoverageSlack = 0.06;
inline constexpr double leastCoverageSlack = 0.02;
inline constexpr double largestCoverageSlack = 1.0;

/// Poisson-disk samples of a mesh, no two of them closer than `radius` along the surface (see
/// GeodesicUnfolding) and every position on the surface within (1 + slack) `radius` of one. Dart throwing,
/// uniform by area times density, places a few samples; then every remaining void gets one. Voids are found
/// by bisecting triangles until each part lies in a sample's disc or is small (after Cline et al. 2009,
/// section 3).
///
/// Space is divided into blocks with a side of 16 times the largest radius, in eight colors. Blocks of one
/// color do not touch and are filled in parallel, so that the samples do not depend on the number of threads.
///
/// With a density the radius is that of LocalRadius, and two samples are at least the smaller of their radii
/// apart.
/// @param areas those of cumulateArea(mesh)
/// @param radius in the points' unit, above 0
/// @param slack coverage slack, clamped to [leastCoverageSlack, largestCoverageSlack]. Larger is faster and
/// gives fewer samples.
/// @param seed random choices hash it with the indices of darts and triangles
/// @throws std::invalid_argument if the mesh is more than 2^24 radii wide, or fits more than 2^28 samples
PoissonDisk samplePoissonDisk(const TriangleMesh& mesh, const CumulativeArea& areas, double radius,
  double slack, std::uint64_t seed, const Progress& progress = {});

/// The number of samples that samplePoissonDisk fits on a flat surface, times radius^2 / area.
double fittedCount(double slack);

} // namespace ink
