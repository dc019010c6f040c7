#pragma once

#include "Fields/GridField.h"
#include "Parallel/ParallelFor.h"
#include "Sampling/CrossedCells.h"
#include "Sampling/Kernels/SamplingKernels.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace ink
{

/// What samples are computed in.
enum class Arithmetic
{
  /// Single precision for values that it holds exactly (integers of 8 and 16 bits, float), double for others.
  /// The side of the surface that a value is on is exact all the same.
  Single,
  Double
};

/// How samples are made of cells.
struct SampleOptions
{
  CrossingRule rule = CrossingRule::HalfOpen;
  NormalMethod method = NormalMethod::CentralDifference;
  /// Points in double are worth computing in double only.
  Arithmetic arithmetic = Arithmetic::Single;
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
  const CrossedCells& cells, std::span<Real> points, std::span<float> normals, const Progress& progress = {});

/// Room for samples: three numbers for each, in what is not null.
struct SampleRoom
{
  float* points = nullptr;
  double* doublePoints = nullptr; ///< instead of points
  float* normals = nullptr;
  std::int16_t* shortNormals = nullptr; ///< unit vectors times 32767, rounded
  std::int8_t* byteNormals = nullptr;   ///< unit vectors times 127, rounded
  std::size_t capacity = 0;             ///< in samples
};

/// Makes room for so many samples, or more, and keeps what was written before.
using GrowRoom = std::function<SampleRoom(std::size_t)>;

/// findCrossedCells and placeIsoSurfaceSamples for several iso-values in one pass over the field; for one,
/// samples are placed while their part of the field is still in the cache.
///
/// \param ranges   as in findCrossedCells
/// \param expected how many samples to make room for at first, for one iso-value. More are no error, but some
/// are
///                 placed later then
/// \param counts   out: the samples of each iso-value; they come iso-value by iso-value
/// \returns false when `progress` asked to stop
template <class T>
bool sampleIsoSurfaces(const GridField<T>& field, std::span<const double> isoValues,
  const SampleOptions& options, const CellSelection& selection, BrickRanges* ranges, const GrowRoom& grow,
  std::size_t expected, std::vector<std::size_t>& counts, const Progress& progress = {});

/// The radius, in world units, of discs around the samples of any iso-surface of the grid that leave no
/// holes: half the diagonal of a cell. One radius for all of them, since lines of an even width need splats
/// of one size.
double isoSurfaceSampleRadius(const GridGeometry& geometry);

} // namespace ink
