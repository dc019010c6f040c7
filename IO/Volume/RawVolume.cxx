// SPDX-License-Identifier: BSD-3-Clause
#include "RawVolume.h"

#include "Core/FormatNumber.h"
#include "Inflater.h"
#include "ReadError.h"

#include "vtkByteSwap.h"
#include "vtkDataArray.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

namespace fs = std::filesystem;

namespace ink::io
{

std::uint64_t RawVolume::offsetIn(std::size_t file) const
{
  return this->offsets.empty() ? this->offset : this->offsets[file];
}

std::uint64_t RawVolume::valueSize() const
{
  return static_cast<std::uint64_t>(vtkDataArray::GetDataTypeSize(this->type));
}

std::uint64_t RawVolume::storedSize() const
{
  return this->halves ? sizeof(std::uint16_t) : this->valueSize();
}

std::uint64_t RawVolume::sliceValues() const
{
  return static_cast<std::uint64_t>(this->dimensions[0]) * static_cast<std::uint64_t>(this->dimensions[1]);
}

std::uint64_t RawVolume::fileBytes() const
{
  return this->sliceValues() * static_cast<std::uint64_t>(this->dimensions[2]) * this->storedSize() *
    static_cast<std::uint64_t>(this->components);
}

void RawVolume::setBigEndian(bool bigEndian)
{
  this->swapped = this->storedSize() > 1 && bigEndian != (std::endian::native == std::endian::big);
}

void RawVolume::checkDimensions(const fs::path& header) const
{
  // In double first, in which nothing overflows.
  double bytes = static_cast<double>(this->valueSize()) * this->components;
  for (const int dimension : this->dimensions)
  {
    bytes *= std::max(dimension, 0);
  }
  constexpr double mostBytes = 1LL << 60;
  if (!(bytes > 0.0 && bytes < mostBytes))
  {
    failToRead(header,
      "its header says dimensions " + formatDimensions(this->dimensions) + " and " +
        std::to_string(this->components) + " components; expected 1 or more that a file can hold");
  }
}

void RawVolume::check(const fs::path& header) const
{
  this->checkDimensions(header);
  if (this->encoding == VoxelEncoding::Pages || this->encoding == VoxelEncoding::Frames)
  {
    return; // what tells their sizes has looked
  }
  for (std::size_t file = 0; file < this->files.size(); ++file)
  {
    const std::uint64_t size = fs::file_size(this->files[file]);
    const std::uint64_t found = size - std::min(size, this->offsetIn(file));
    std::uint64_t needed = this->fileBytes() / this->files.size();
    std::uint64_t most = found;
    if (this->encoding == VoxelEncoding::Compressed)
    {
      needed += this->skipped;
      most = found * Inflater::mostPerByte;
    }
    else if (this->encoding == VoxelEncoding::Runs)
    {
      // Two bytes make 127 at most.
      constexpr std::uint64_t mostOfARun = 127;
      most = found * mostOfARun / 2;
    }
    else if (this->encoding == VoxelEncoding::Text)
    {
      // A digit and a space.
      needed /= this->valueSize();
      most = (found + 1) / 2;
    }
    if (most < needed)
    {
      failToRead(header,
        "it has " + std::to_string(found) + " bytes of " +
          (this->encoding == VoxelEncoding::Plain
              ? "data"
              : (this->encoding == VoxelEncoding::Text ? "text" : "compressed data")) +
          ", but its header promises " + std::to_string(needed) +
          (this->encoding == VoxelEncoding::Text ? " values" : ""));
    }
  }
}

RawVolumeReader::RawVolumeReader(RawVolume voxels)
  : Voxels(std::move(voxels))
  , Bytes(VoxelBytes::open(this->Voxels))
{
}

void RawVolumeReader::read(const int extent[6], std::span<unsigned char> values, const Progress& progress)
{
  const int* dimensions = this->Voxels.dimensions;
  const auto size = [extent](int axis)
  {
    const int count = extent[2 * axis + 1] - extent[2 * axis] + 1;
    return static_cast<std::uint64_t>(count);
  };
  const std::uint64_t valueSize = this->Voxels.valueSize();
  const bool wholeRows = size(0) == static_cast<std::uint64_t>(dimensions[0]);
  const bool wholeSlices = wholeRows && size(1) == static_cast<std::uint64_t>(dimensions[1]);
  const std::uint64_t sliceSize = size(0) * size(1) * valueSize;
  // Some slices at a time, to say how far it is.
  constexpr std::uint64_t bytesOfAStep = 1 << 24;
  const std::uint64_t atOnce = wholeSlices ? std::max<std::uint64_t>(bytesOfAStep / sliceSize, 1) : 1;
  std::vector<unsigned char> rows(
    wholeRows ? 0 : static_cast<std::uint64_t>(dimensions[0]) * size(1) * valueSize);
  for (std::uint64_t n = 0; n < size(2); n += atOnce)
  {
    advance(progress, static_cast<double>(n) / static_cast<double>(size(2)));
    const std::uint64_t slice = static_cast<std::uint64_t>(extent[4]) + n;
    const std::uint64_t first =
      slice * static_cast<std::uint64_t>(dimensions[1]) + static_cast<std::uint64_t>(extent[2]);
    const std::span<unsigned char> part =
      values.subspan(n * sliceSize, std::min(atOnce, size(2) - n) * sliceSize);
    if (wholeRows)
    {
      this->readRows(first, part);
      continue;
    }
    this->readRows(first, rows);
    for (std::uint64_t y = 0; y < size(1); ++y)
    {
      const std::uint64_t from =
        y * static_cast<std::uint64_t>(dimensions[0]) + static_cast<std::uint64_t>(extent[0]);
      std::memcpy(&part[y * size(0) * valueSize], &rows[from * valueSize], size(0) * valueSize);
    }
  }
}

/// Reads whole rows from one on, counted through all slices.
void RawVolumeReader::readRows(std::uint64_t first, std::span<unsigned char> values)
{
  const std::uint64_t valueSize = this->Voxels.valueSize();
  const auto components = static_cast<std::uint64_t>(this->Voxels.components);
  std::uint64_t position =
    first * static_cast<std::uint64_t>(this->Voxels.dimensions[0]) * valueSize * components;
  if (this->Voxels.halves)
  {
    this->readHalves(position, values);
    return;
  }
  if (components == 1)
  {
    this->Bytes->read(position, values);
  }
  else
  {
    // A row at a time: only one component of it is kept.
    const std::uint64_t rowSize = static_cast<std::uint64_t>(this->Voxels.dimensions[0]) * valueSize;
    std::vector<unsigned char> all(rowSize * components);
    for (std::size_t begin = 0; begin < values.size(); begin += rowSize, position += all.size())
    {
      this->Bytes->read(position, all);
      for (std::uint64_t n = 0; n < static_cast<std::uint64_t>(this->Voxels.dimensions[0]); ++n)
      {
        std::memcpy(&values[begin + n * valueSize], &all[n * components * valueSize], valueSize);
      }
    }
  }
  if (this->Voxels.swapped)
  {
    vtkByteSwap::SwapVoidRange(values.data(), values.size() / valueSize, valueSize);
  }
}

/// @param position of floats of one component
void RawVolumeReader::readHalves(std::uint64_t position, std::span<unsigned char> values)
{
  const std::size_t count = values.size() / sizeof(float);
  std::vector<std::uint16_t> halves(count);
  const std::span<unsigned char> bytes(
    reinterpret_cast<unsigned char*>(halves.data()), count * sizeof(std::uint16_t));
  this->Bytes->read(position / 2, bytes);
  if (this->Voxels.swapped)
  {
    vtkByteSwap::SwapVoidRange(halves.data(), count, sizeof(std::uint16_t));
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const float value = glm::unpackHalf1x16(halves[i]);
    std::memcpy(&values[i * sizeof(float)], &value, sizeof(float));
  }
}

} // namespace ink::io
