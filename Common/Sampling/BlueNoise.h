#pragma once

#include "Parallel/ParallelFor.h"
#include "Sampling/TriangleMesh.h"

#include <cstdint>
#include <vector>

namespace ink
{

/// Samples of which no two are nearer along the surface than a radius, and which leave little room for
/// another.
struct BlueNoise
{
  std::vector<SurfaceSample> samples;
  /// The radius at the mean density; with a density, see radiusAt. In the mesh's unit.
  double radius = 0.0;
  bool stopped = false;
};

/// The share of the area that half-radius discs of a random sampling cover when no more fit: the jamming
/// limit of random sequential adsorption (Feder 1980), as a number of samples: this times area / radius^2.
inline constexpr double saturatedCount = 0.547 * 4.0 / 3.14159265358979;

/// The distance between neighbors when `count` points stand in a hexagonal lattice, which no arrangement in
/// the plane exceeds: sqrt(2 area / (sqrt(3) count)).
double hexagonalDistance(double area, double count);

/// The radius at a place of the mesh: radius / sqrt(density / mean density). It goes up to sixteen times the
/// least.
class LocalRadius
{
public:
  LocalRadius(const TriangleMesh& mesh, const CumulativeArea& areas, double radius);
  double least() const { return this->Least; }
  double most() const { return this->Most; }
  /// At least least(), at most 16 times that.
  double at(float density) const;

private:
  bool Constant;
  double Scale; // radius at density 1
  double Least;
  double Most;
};

/// How far beyond the radius, as a part of it, a place may be from all samples before one is put there. It
/// can be chosen within these; the first is nearly as fast as any other.
inline constexpr double defaultGap = 0.06;
inline constexpr double leastGap = 0.02;
inline constexpr double largestGap = 1.0;

/// Poisson-disc samples of a mesh, no two of them nearer than `radius` along the surface (see
/// SurfaceUnfolding) and every place of the surface within (1 + gap) `radius` of one: a few random darts,
/// evenly by area times density, then one into every gap that is left. Gaps are found by halving triangles
/// until each part lies in a sample's disc or is small (after Cline et al. 2009, section 3).
///
/// Space is cut into blocks of 16 of the largest radii. Blocks of one of eight colors do not touch and are
/// filled in parallel, so that the samples do not depend on the number of threads.
///
/// With a density the radius is that of LocalRadius, and two samples keep the smaller of their radii apart.
/// @param areas those of cumulateArea(mesh)
/// @param radius in the points' unit, above 0
/// @param gap is brought between leastGap and largestGap. Larger is faster, and gives fewer samples.
/// @param seed together with indices of darts and triangles all that the choice depends on
/// @throw std::invalid_argument if the mesh is more than 2^24 radii wide, or has room for more than 2^28
/// samples
BlueNoise sampleBlueNoise(const TriangleMesh& mesh, const CumulativeArea& areas, double radius, double gap,
  std::uint64_t seed, const Progress& progress = {});

/// How many samples sampleBlueNoise fits on a flat surface: this times area / radius^2.
double fittedCount(double gap);

} // namespace ink
