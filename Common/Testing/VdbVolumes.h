// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "OpenVDBTrees.h"
#include "SampledVolume.h"

#include "Fields/Vdb/VdbWrite.h"
#include "IsoSurface/Vdb/VdbSamples.h"

#include <openvdb/io/Stream.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string>

namespace ink::testing
{

/// Grids as a file, as OpenVDB itself writes it.
inline std::string fileOf(const openvdb::GridPtrVec& grids)
{
  openvdb::initialize();
  std::ostringstream out(std::ios::binary);
  openvdb::io::Stream(out).write(grids);
  return out.str();
}

/// The grid of that name in a file, read by vtkInk.
inline VdbGrid readGrid(
  const std::string& file, const std::string& name = "", std::uint64_t memory = VdbGrid::noLimit)
{
  std::istringstream in(file, std::ios::binary);
  const VdbFile list = VdbFile::list(in);
  return VdbGrid::read(in, list, list.find(name), memory);
}

template <class Grid>
VdbGrid readBack(const typename Grid::Ptr& grid)
{
  return readGrid(fileOf({ grid }));
}

/// A box of a sparse grid as a dense volume.
template <class T>
Volume<T> denseOf(const VdbGrid& grid, const VoxelBox& box, bool negate = false)
{
  Volume<T> volume(grid.geometry(box));
  grid.copyTo(box, negate, std::span<T>(volume.values));
  return volume;
}

/// The box, a few voxels wider on all sides.
inline VoxelBox padded(const VoxelBox& box, int by)
{
  return { box.first - by, box.last + by };
}

template <class Real = double>
Samples<Real> sampleIsoSurface(
  const VdbGrid& grid, double isoValue, const SampleOptions& options = {}, bool negate = false)
{
  const VdbActiveCells cells = findActiveCells(grid, isoValue, options.rule, negate);
  Samples<Real> samples;
  samples.coordinates.resize(3 * cells.count);
  samples.components.resize(3 * cells.count);
  placeIsoSurfaceSamples(grid, isoValue, options, negate, cells, std::span<Real>(samples.coordinates),
    std::span<float>(samples.components));
  return samples;
}

/// Samples as they compare whatever their order: each a point and a normal, sorted.
template <class Real>
std::vector<std::array<Real, 6>> sorted(const Samples<Real>& samples)
{
  std::vector<std::array<Real, 6>> rows(samples.size());
  for (std::size_t n = 0; n < rows.size(); ++n)
  {
    std::copy_n(&samples.coordinates[3 * n], 3, rows[n].begin());
    std::copy_n(&samples.components[3 * n], 3, rows[n].begin() + 3);
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

} // namespace ink::testing
