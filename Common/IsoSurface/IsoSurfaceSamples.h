// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "IsoSurface/ActiveCellId.h"
#include "IsoSurface/ActiveCells.h"
#include "Simd/SamplingKernels.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace ink
{

template <class T>
class GridField;
class GridGeometry;

/// The precision in which samples are computed.
enum class Arithmetic
{
  /// Single precision for values that it represents exactly (integers of 8 and 16 bits, float), double for
  /// others. Classifying values as inside or outside is exact in either case.
  Single,
  Double
};

/// How samples are placed in cells.
struct SampleOptions
{
  CrossingRule rule = CrossingRule::HalfOpen;
  NormalMethod method = NormalMethod::InterpolatedNormal;
  /// Points in double should be computed in double.
  Arithmetic arithmetic = Arithmetic::Single;
};

/// Places one sample in each of the given cells: at the mean of the iso-surface's intersections with the
/// cell's edges, with the normal there (Zhang et al. 2014, section 5.1).
///
/// @param cells from findActiveCells with the same field, isoValue and rule; samples are in the same order
/// @param points 3 * cells.count numbers, x y z of each sample in world units; Real is float or double
/// @param normals 3 * cells.count numbers, or empty for none. Unit vectors towards smaller values, by
///   NormalMethod. Where the corners' directions cancel or all vanish, along the gradient of the cell's own
///   values, and where that vanishes too, along the intersected edges
/// @throws std::invalid_argument when a span has the wrong length
/// @return false when `progress` asked to stop; then some samples are missing
template <class T, class Real>
bool placeIsoSurfaceSamples(const GridField<T>& field, double isoValue, const SampleOptions& options,
  const ActiveCells& cells, std::span<Real> points, std::span<float> normals, const Progress& progress = {});

/// Output arrays for samples, of three numbers each but for the cells; null for those that are not wanted.
struct SampleRoom
{
  float* points = nullptr;
  double* doublePoints = nullptr; ///< instead of points
  float* normals = nullptr;
  std::int16_t* shortNormals = nullptr; ///< unit vectors times 32767, rounded
  std::int8_t* byteNormals = nullptr;   ///< unit vectors times 127, rounded
  std::size_t capacity = 0;             ///< in samples
  ActiveCellId* cells = nullptr;        ///< the cell of each sample, by its global index
};

/// Reallocates the output for at least that many samples, keeping those written before.
using GrowRoom = std::function<SampleRoom(std::size_t)>;

/// findActiveCells and placeIsoSurfaceSamples for several iso-values in one pass over the field; for one,
/// samples are placed while their part of the field is still in the cache.
///
/// @param ranges as in findActiveCells
/// @param expected the number of samples to allocate at first, for one iso-value. More are no error, but some
///   are then placed in a second pass
/// @param counts output: the number of samples of each iso-value; samples are sorted by iso-value
/// @return false when `progress` asked to stop
template <class T>
bool sampleIsoSurfaces(const GridField<T>& field, std::span<const double> isoValues,
  const SampleOptions& options, const CellSelection& selection, MinMaxBricks* ranges, const GrowRoom& grow,
  std::size_t expected, std::vector<std::size_t>& counts, const Progress& progress = {});

/// The radius, in world units, with which discs around the samples of any iso-surface of the grid leave no
/// holes: half the diagonal of a cell. One radius for all, since lines of even width need splats of one size.
double isoSurfaceSampleRadius(const GridGeometry& geometry);
/// @param cell a cell's edges as columns, world units
double isoSurfaceSampleRadius(const glm::dmat3& cell);

/// The share of that radius within which discs leave no holes where a surface follows two axes of the grid,
/// so that samples stand in rows: half of the longest diagonal of a cell's faces. sqrt(2/3) for cubes, nearly
/// 1 for cells that are much longer than wide; 0 for a cell without a size. Where a surface is oblique,
/// samples are closer, and it suffices, too.
/// @param cell a cell's edges as columns
double isoSurfaceSampleReach(const glm::dmat3& cell);

/// The area of a flat surface per sample, on average: the cells that it crosses are those whose middle is no
/// farther from it than half the width of a cell along its normal.
/// @param cell a cell's edges as columns, world units
/// @param normal unit
/// @return in square world units
double isoSurfaceSampleArea(const glm::dmat3& cell, const glm::dvec3& normal);

} // namespace ink
