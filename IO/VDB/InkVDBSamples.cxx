// SPDX-License-Identifier: BSD-3-Clause
#include "InkVDBSamples.h"

#include "Fields/Vdb/VdbField.h"
#include "InkAllocate.h"
#include "InkImageGrid.h"
#include "InkPrecision.h"
#include "InkVDBSource.h"
#include "IsoSurface/IsoSurfaceSamples.h"
#include "IsoSurface/ProjectSamples.h"
#include "IsoSurface/Vdb/VdbSamples.h"

#include "vtkAlgorithm.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <string>

namespace
{

/// A piece's share of the blocks.
ink::VdbActiveCells ShareOf(ink::VdbActiveCells cells, int piece, int pieces)
{
  const auto at = [&](int n)
  {
    return cells.blocks.begin() +
      static_cast<std::ptrdiff_t>(
        cells.blocks.size() * static_cast<std::size_t>(n) / static_cast<std::size_t>(pieces));
  };
  ink::VdbActiveCells share;
  share.blocks.assign(at(piece), at(piece + 1));
  for (ink::VdbActiveCells::Block& block : share.blocks)
  {
    block.before = share.count;
    for (const std::uint64_t layer : block.cells)
    {
      share.count += static_cast<std::size_t>(std::popcount(layer));
    }
  }
  return share;
}

/// @return false when stopped
template <class Array, class NextStep>
bool PlaceSamples(const ink::VdbGrid& grid, const std::vector<double>& isoValues,
  const std::vector<ink::VdbActiveCells>& cells, const ink::VdbTileOptions& options, Array* points,
  vtkFloatArray* normals, const NextStep& nextStep)
{
  using Real = typename Array::ValueType;
  Real* point = points->GetPointer(0);
  float* normal = normals ? normals->GetPointer(0) : nullptr;
  // As in the dense copy, inactive voxels have their values.
  const ink::VdbField field(grid, ink::VdbField::Inactive::Background);
  const ink::GridGeometry geometry = grid.geometry(grid.activeBox());
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const std::size_t size = 3 * cells[i].count;
    if (!ink::placeIsoSurfaceSamples(grid, isoValues[i], options.samples, options.negate, cells[i],
          std::span<Real>(point, size), std::span<float>(normal, normal ? size : 0), nextStep()))
    {
      return false;
    }
    // Of -f the surface is at minus the iso-value, and the steps to it are the same.
    const double isoValue = options.negate ? -isoValues[i] : isoValues[i];
    if (options.projectionSteps > 0 &&
      !ink::projectSamples(
        field, geometry, isoValue, options.projectionSteps, std::span<Real>(point, size), nextStep()))
    {
      return false;
    }
    point += size;
    normal += normal ? size : 0;
  }
  return true;
}

/// @return false when stopped
template <class Array>
bool SampleTiles(const ink::VdbGrid& grid, const std::vector<double>& isoValues,
  const ink::VdbTileOptions& options, Array* points, vtkFloatArray* normals, std::vector<std::size_t>& counts,
  const ink::Progress& progress)
{
  ink::VdbTileSamples<typename Array::ValueType> samples;
  if (!ink::sampleVdbTiles(grid, isoValues, options, samples, progress))
  {
    return false;
  }
  InkSetNumberOfTuples(points, static_cast<vtkIdType>(samples.points.size() / 3));
  std::copy(samples.points.begin(), samples.points.end(), points->GetPointer(0));
  if (normals)
  {
    InkSetNumberOfTuples(normals, points->GetNumberOfTuples());
    std::copy(samples.normals.begin(), samples.normals.end(), normals->GetPointer(0));
  }
  counts = samples.counts;
  return true;
}

/// The active cells of a piece, for each iso-value.
/// @param nextStep makes the progress of the next step
/// @throws ink::VdbTooLarge where the points would take more memory than is allowed
template <class NextStep>
std::vector<ink::VdbActiveCells> FindCells(
  const ink::VdbGrid& grid, const InkVDBSampleRequest& request, const NextStep& nextStep)
{
  const ink::VdbTileOptions& options = request.Options;
  std::vector<ink::VdbActiveCells> cells;
  std::uint64_t count = 0;
  for (const double isoValue : request.IsoValues)
  {
    cells.push_back(ShareOf(
      ink::findActiveCells(grid, isoValue, options.samples.rule, options.negate, nextStep(), options.memory),
      options.piece, options.pieces));
    count += cells.back().count;
    // Per sample a point, a normal and at most a radius, an index and a vertex.
    constexpr std::uint64_t bytesPerPoint = 48;
    if (count > options.memory / bytesPerPoint)
    {
      throw ink::VdbTooLarge("the surface has " + std::to_string(count) + " points or more, which take " +
        InkMebibytes(static_cast<double>(count * bytesPerPoint)));
    }
  }
  return cells;
}

/// Calls a function with the points' array in its own type.
template <class Use>
bool WithPoints(vtkPoints* points, const Use& use)
{
  auto* doubles = vtkDoubleArray::SafeDownCast(points->GetData());
  return doubles ? use(doubles) : use(vtkFloatArray::SafeDownCast(points->GetData()));
}

} // namespace

bool InkVDBSampleRequest::TakesTiles() const
{
  return this->Options.ofMask || this->Options.shapeBased || this->Options.smoothing > 0.0 ||
    this->Options.subdivision > 1 || this->Options.cut != ink::CutSurface::Open ||
    !this->Options.parts.keepsAll();
}

std::optional<InkVDBSamples> InkSampleVDB(
  const ink::VdbGrid& grid, const InkVDBSampleRequest& request, const ink::Progress& progress)
{
  // One step to find an iso-value's cells, one to place its samples and one to project them.
  bool stopped = false;
  double step = 0.0;
  const double steps = (request.Options.projectionSteps > 0 ? 3.0 : 2.0) *
    std::max<double>(1.0, static_cast<double>(request.IsoValues.size()));
  const auto nextStep = [&]() -> ink::Progress
  {
    return [&, before = step++](double fraction)
    {
      stopped = stopped || !progress((before + fraction) / steps);
      return !stopped;
    };
  };
  const bool tiles = request.TakesTiles();
  std::vector<ink::VdbActiveCells> cells;
  if (!tiles)
  {
    cells = FindCells(grid, request, nextStep);
  }
  if (stopped)
  {
    return {};
  }
  const ink::GridGeometry geometry = grid.geometry(grid.activeBox());
  InkVDBSamples samples{ {}, {}, {}, geometry };
  std::size_t count = 0;
  for (const ink::VdbActiveCells& own : cells)
  {
    samples.Counts.push_back(own.count);
    count += own.count;
  }

  const bool doubles = request.PointsPrecision == vtkAlgorithm::DOUBLE_PRECISION ||
    (request.PointsPrecision == vtkAlgorithm::DEFAULT_PRECISION && (count > 0 || tiles) &&
      InkNeedsDoublePrecision(geometry));
  ink::VdbTileOptions options = request.Options;
  options.samples.arithmetic =
    doubles || request.DoubleArithmetic ? ink::Arithmetic::Double : ink::Arithmetic::Single;
  samples.Points = vtkSmartPointer<vtkPoints>::New();
  samples.Points->SetDataType(doubles ? VTK_DOUBLE : VTK_FLOAT);
  InkSetNumberOfPoints(samples.Points, static_cast<vtkIdType>(count));
  if (options.normals)
  {
    samples.Normals = vtkSmartPointer<vtkFloatArray>::New();
    samples.Normals->SetName("Normals");
    samples.Normals->SetNumberOfComponents(3);
    InkSetNumberOfTuples(samples.Normals, static_cast<vtkIdType>(count));
  }
  bool done = false;
  if (tiles)
  {
    const ink::IsoSurfaceResampling resampling = ink::makeIsoSurfaceResampling(
      geometry, options.smoothing, options.subdivision, options.target, options.ofMask, options.shapeBased);
    samples.Cells = ink::resampledGeometry(geometry, resampling.subdivision);
    done = WithPoints(samples.Points,
      [&](auto* points) {
        return SampleTiles(
          grid, request.IsoValues, options, points, samples.Normals, samples.Counts, progress);
      });
  }
  else
  {
    done = WithPoints(samples.Points,
      [&](auto* points)
      { return PlaceSamples(grid, request.IsoValues, cells, options, points, samples.Normals, nextStep); });
  }
  return done ? std::optional(samples) : std::nullopt;
}
