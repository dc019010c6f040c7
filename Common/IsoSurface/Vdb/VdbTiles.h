// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Fields/Vdb/VdbGrid.h"
#include "IsoSurface/ActiveCellComponents.h"
#include "IsoSurface/CutSamples.h"
#include "IsoSurface/IsoSurfaceSamples.h"
#include "IsoSurface/ResampledSamples.h"

#include <cstddef>
#include <span>
#include <vector>

namespace ink
{

/// How iso-surfaces of a sparse grid are sampled that is smoothed and divided, of which parts are left out,
/// or that has rims.
struct VdbTileOptions
{
  SampleOptions samples;
  bool negate = false;    ///< the values are multiplied by -1 first
  double smoothing = 0.0; ///< as for makeIsoSurfaceResampling
  int subdivision = 1;
  SmoothingTarget target = SmoothingTarget::Surface;
  bool ofMask = false;               ///< see IsoSurfaceResampling
  bool shapeBased = false;           ///< as for makeIsoSurfaceResampling
  bool borders = false;              ///< the same
  int projectionSteps = 0;           ///< see projectSamples
  CutSurface cut = CutSurface::Open; ///< where the surface leaves the grid's domain, if it has one
  ComponentSelection parts;          ///< of each whole surface
  bool normals = true;
  int piece = 0;
  int pieces = 1;
  std::uint64_t memory = VdbGrid::noLimit; ///< in bytes, of the samples
};

/// The samples of several iso-surfaces, those of one after the other.
template <class Real>
struct VdbTileSamples
{
  std::vector<Real> points;        ///< three numbers each
  std::vector<float> normals;      ///< the same, or empty
  std::vector<std::size_t> counts; ///< the samples of each iso-value
};

/// Samples like sampleResampledIsoSurfaces, sampleCut and selectComponents on the grid made dense, but copies
/// only tiles of 32^3 voxels near the surface, and what their smoothed values depend on. Points and normals
/// are bitwise those of a dense copy that is as large as the Gaussian needs. A smoothed surface is looked for
/// where the values themselves cross an iso-value within the kernel's reach: one that only its negative
/// weights made would be missed. Samples are sorted by iso-value, then by tile, and the same for any number
/// of threads. Pieces put together have the samples of the whole; where parts are left out, each piece looks
/// at the whole.
///
/// @tparam Real of points, float or double; options.samples.arithmetic should be Double for the latter
/// @throws VdbTooLarge; std::invalid_argument if parts are to be left out of a grid whose indices exceed
/// those of
///   ActiveCellId, but for ComponentSelection::automatic, which keeps all parts of such a grid
/// @return false when `progress` asked to stop
template <class Real>
bool sampleVdbTiles(const VdbGrid& grid, std::span<const double> isoValues, const VdbTileOptions& options,
  VdbTileSamples<Real>& samples, const Progress& progress = {});

} // namespace ink
