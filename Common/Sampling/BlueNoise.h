#pragma once

#include "Parallel/ParallelFor.h"
#include "Sampling/TriangleMesh.h"

#include <cstdint>
#include <vector>

namespace ink
{

/// Samples of which no two are nearer along the surface than a radius, and which leave no room for another.
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

/// The distance between neighbours when `count` points stand in a hexagonal lattice, which no arrangement in
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

/// Poisson-disc samples of a mesh, no two of them nearer than `radius` along the surface (see SurfaceWalk)
/// and every place of the surface within 1.03 `radius` of one: random darts first, thrown evenly by area
/// times density, then one into every gap that is left. Gaps are found by halving triangles until each part
/// lies in a sample's disc or is small (after Cline et al. 2009, section 3).
///
/// Space is cut into blocks of 16 radii. Blocks of one of eight colours do not touch and are filled in
/// parallel, so that the samples do not depend on the number of threads.
///
/// With a density the radius is that of LocalRadius, and two samples keep the smaller of their radii apart.
/// @param areas those of cumulateArea(mesh)
/// @param radius in the points' unit, above 0
/// @param seed together with indices of darts and triangles all that the choice depends on
/// @throw std::invalid_argument if the mesh is more than 2^24 radii wide
BlueNoise sampleBlueNoise(const TriangleMesh& mesh, const CumulativeArea& areas, double radius,
  std::uint64_t seed, const Progress& progress = {});

} // namespace ink
