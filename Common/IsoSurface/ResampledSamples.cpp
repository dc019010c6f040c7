// SPDX-License-Identifier: BSD-3-Clause
#include "IsoSurface/ResampledSamples.h"

#include "Core/ParallelFor.h"
#include "Fields/Grid/GridField.h"
#include "Fields/ScalarDifference.h"
#include "IsoSurface/ResampledSampler.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace ink
{

int subdivisionAlong(double ratio, int subdivision)
{
  constexpr double usualMost = 8.0;
  constexpr double longestCell = 3.0;
  const double cubes = std::round(ratio * std::max(subdivision, 1));
  const double most = cubes > longestCell * usualMost ? largestSubdivision : usualMost;
  return static_cast<int>(std::clamp(cubes, 1.0, most));
}

IsoSurfaceResampling makeIsoSurfaceResampling(const GridGeometry& geometry, double smoothing, int subdivision,
  SmoothingTarget target, bool ofMask, bool shapeBased)
{
  IsoSurfaceResampling resampling;
  resampling.ofMask = ofMask;
  resampling.slices = shapeBased ? thickSlices(geometry.spacing()) : std::nullopt;
  if (!(smoothing > 0.0) && subdivision <= 1 && !resampling.slices)
  {
    return resampling;
  }
  resampling.target = target;
  resampling.deviation = smoothingDeviation(geometry, std::max(smoothing, 0.0));
  const glm::dvec3 ratios = spacingRatios(geometry);
  for (int axis = 0; axis < 3; ++axis)
  {
    resampling.subdivision[axis] = subdivisionAlong(ratios[axis], subdivision);
  }
  return resampling;
}

glm::ivec3 isoSurfaceResamplingReach(
  double smoothing, int subdivision, const std::optional<ThickSlices>& slices)
{
  if (!(smoothing > 0.0) && subdivision <= 1 && !slices)
  {
    return glm::ivec3(1);
  }
  // Along the axis of the smallest spacing, where the Gaussian is widest in samples; others may be divided
  // more. One more sample for the normals.
  const int ofKernels = 1 +
    std::max(AxisResampling(smoothing, largestSubdivision, 2).reach(),
      AxisResampling(fourthOrderShare * smoothing, largestSubdivision, 2, SmoothingKernel::FourthOrder)
        .reach());
  return glm::ivec3(ofKernels) + (slices ? slices->samples() : glm::ivec3(0));
}

GridGeometry resampledGeometry(const GridGeometry& geometry, const glm::ivec3& subdivision)
{
  return GridGeometry((geometry.dimensions() - 1) * subdivision + 1, geometry.origin(),
    geometry.spacing() / glm::dvec3(subdivision), geometry.direction(), geometry.first() * subdivision);
}

namespace
{

/// Each iso-value has a mask, or distances, of its own.
template <class T>
bool sampleEach(const GridField<T>& field, std::span<const double> isoValues, const SampleOptions& options,
  const CellSelection& selection, const IsoSurfaceResampling& resampling, int projectionSteps,
  TileRanges* ranges, const GrowRoom& grow, std::vector<std::size_t>& counts, const Progress& progress)
{
  counts.clear();
  std::size_t before = 0;
  for (std::size_t n = 0; n < isoValues.size(); ++n)
  {
    const auto part = [&](double done) {
      return !progress || progress((static_cast<double>(n) + done) / static_cast<double>(isoValues.size()));
    };
    const GrowRoom growRest = [&](std::size_t count) { return roomAfter(grow(before + count), before); };
    std::vector<std::size_t> own;
    if (!sampleResampledIsoSurfaces(field, isoValues.subspan(n, 1), options, selection, resampling,
          projectionSteps, ranges, growRest, own, part))
    {
      return false;
    }
    counts.push_back(own.front());
    before += own.front();
  }
  return true;
}

/// Samples a grid's values, or the distances between slices that were made of its labels.
/// @param labels of the same geometry; null: none that normals show
template <class T, class L>
bool sampleGrid(const GridField<T>& field, const GridField<L>* labels, double labelIsoValue,
  std::span<const double> isoValues, const SampleOptions& options, const CellSelection& selection,
  const IsoSurfaceResampling& resampling, int projectionSteps, TileRanges* ranges, const GrowRoom& grow,
  std::vector<std::size_t>& counts, const Progress& progress)
{
  const auto run = [&](auto zero)
  {
    using Work = decltype(zero);
    const auto readerOf = [&](const auto& grid) -> SampleReader<Work>
    {
      return [&](const SampleBox& positions, const glm::ivec3& reach, TileResampler<Work>& to)
      { to.read(grid, positions, resampling.subdivision, reach); };
    };
    const auto lacksCorner = [&](const glm::ivec3& cell)
    {
      bool lacks = false;
      for (int c = 0; c < 8; ++c)
      {
        lacks |= !field.has(cell + glm::ivec3(c & 1, c >> 1 & 1, c >> 2));
      }
      return lacks;
    };
    ResampledRequest<Work> request = { field.geometry(), readerOf(field), lacksCorner, isoValues, options,
      selection, resampling, projectionSteps };
    if (labels)
    {
      request.labels = { readerOf(*labels), labelIsoValue };
    }
    return ResampledSampler<Work>(request, ranges).run(grow, counts, progress);
  };
  if constexpr (FitsSingle<T> && FitsSingle<L>)
  {
    if (options.arithmetic == Arithmetic::Single)
    {
      return run(0.0f);
    }
  }
  return run(0.0);
}

} // namespace

template <class T>
bool sampleResampledIsoSurfaces(const GridField<T>& field, std::span<const double> isoValues,
  const SampleOptions& options, const CellSelection& selection, const IsoSurfaceResampling& resampling,
  int projectionSteps, TileRanges* ranges, const GrowRoom& grow, std::vector<std::size_t>& counts,
  const Progress& progress)
{
  const glm::ivec3& samples = field.geometry().dimensions();
  if (std::min({ samples.x, samples.y, samples.z }) < 2)
  {
    counts.assign(isoValues.size(), 0);
    return true;
  }
  if ((resampling.ofMask || resampling.slices) && isoValues.size() > 1)
  {
    return sampleEach(
      field, isoValues, options, selection, resampling, projectionSteps, ranges, grow, counts, progress);
  }
  if (!resampling.slices || isoValues.empty())
  {
    return sampleGrid<T, T>(field, nullptr, 0.0, isoValues, options, selection, resampling, projectionSteps,
      ranges, grow, counts, progress);
  }
  // About a fourth of the work.
  const double share = 0.25;
  const auto partOf = [&](double begin, double end)
  { return [&, begin, end](double done) { return !progress || progress(begin + done * (end - begin)); }; };
  const std::vector<float> distances =
    sliceDistances(field, isoValues.front(), resampling.ofMask, *resampling.slices, partOf(0.0, share));
  if (distances.empty())
  {
    return false;
  }
  constexpr double contour = 0.0;
  // Of another iso-value, ranges would be others.
  return sampleGrid(GridField<float>(field.geometry(), distances), resampling.ofMask ? &field : nullptr,
    isoValues.front(), std::span(&contour, 1), options, selection, resampling.ofDistances(), projectionSteps,
    nullptr, grow, counts, partOf(share, 1.0));
}

#define INK_INSTANTIATE(T)                                                                                   \
  template bool sampleResampledIsoSurfaces(const GridField<T>&, std::span<const double>,                     \
    const SampleOptions&, const CellSelection&, const IsoSurfaceResampling&, int, TileRanges*,               \
    const GrowRoom&, std::vector<std::size_t>&, const Progress&);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
