#pragma once

#include "Fields/GridField.h"
#include "Parallel/ParallelFor.h"
#include "Sampling/CrossedCells.h"
#include "Sampling/Kernels/SamplingKernels.h"

#include <cstdint>
#include <span>

namespace ink
{

/// What samples are computed in.
enum class Arithmetic
{
  /// Single precision for values that it holds exactly (integers of 8 and 16 bits, float), double for others. The
  /// side of the surface that a value is on is exact all the same.
  Single,
  Double
};

/// How samples are made of cells.
struct SampleOptions
{
  CrossingRule rule = CrossingRule::HalfOpen;
  NormalMethod method = NormalMethod::CentralDifference;
  /// Points in double are computed in double whatever this says.
  Arithmetic arithmetic = Arithmetic::Single;
};

/// Where normals go: three numbers for each sample in one of these, or nowhere.
struct NormalSpans
{
  std::span<float> floats;
  /// Unit vectors times 32767 and 127, rounded.
  std::span<std::int16_t> shorts;
  std::span<std::int8_t> bytes;
};

/// Places one sample in each of the given cells: at the mean of the iso-surface's intersections with the
/// cell's edges, with the normal there (Zhang et al. 2014, section 5.1).
///
/// \param cells   from findCrossedCells with the same field, isoValue and rule; their order is the samples'
/// \param points  3 * cells.count numbers, x y z of each sample in world units; Real is float or double
/// \param normals 3 * cells.count numbers, or empty for none. Unit vectors towards smaller values, by
///                NormalMethod. Where the corners' directions cancel or all vanish, along the gradient of the
///                cell's own values, and where that vanishes too, along the crossed edges
/// \throws std::invalid_argument when a span has another length
/// \returns false when `progress` asked to stop; then some samples were left out
template <class T, class Real>
bool placeIsoSurfaceSamples(const GridField<T>& field, double isoValue, const SampleOptions& options,
  const CrossedCells& cells, std::span<Real> points, const NormalSpans& normals, const Progress& progress = {});

/// The radius, in world units, of discs around the samples of any iso-surface of the grid that leave no
/// holes: half the diagonal of a cell. One radius for all of them, since lines of an even width need splats
/// of one size.
double isoSurfaceSampleRadius(const GridGeometry& geometry);

} // namespace ink
