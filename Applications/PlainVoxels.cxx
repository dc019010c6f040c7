#include "PlainVoxels.h"

#include "Inflater.h"
#include "ReadFile.h"
#include "Text.h"

#include "vtkByteSwap.h"
#include "vtkDataArray.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

namespace fs = std::filesystem;

namespace ink::cli
{

std::uint64_t PlainVoxels::valueSize() const
{
  return static_cast<std::uint64_t>(vtkDataArray::GetDataTypeSize(this->type));
}

std::uint64_t PlainVoxels::sliceValues() const
{
  return static_cast<std::uint64_t>(this->dimensions[0]) * static_cast<std::uint64_t>(this->dimensions[1]);
}

std::uint64_t PlainVoxels::fileBytes() const
{
  return this->sliceValues() * static_cast<std::uint64_t>(this->dimensions[2]) * this->valueSize() *
    static_cast<std::uint64_t>(this->components);
}

void PlainVoxels::setBigEndian(bool bigEndian)
{
  this->swapped = this->valueSize() > 1 && bigEndian != (std::endian::native == std::endian::big);
}

void PlainVoxels::checkDimensions(const fs::path& header) const
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
      "its header says dimensions " + dimensionsText(this->dimensions) + " and " +
        std::to_string(this->components) + " components; expected 1 or more that a file can hold");
  }
}

void PlainVoxels::check(const fs::path& header) const
{
  this->checkDimensions(header);
  for (const fs::path& file : this->files)
  {
    const std::uint64_t size = fs::file_size(file);
    const std::uint64_t found = size - std::min(size, this->offset);
    std::uint64_t needed = this->fileBytes() / this->files.size();
    std::uint64_t most = found;
    if (this->encoding == VoxelEncoding::Compressed)
    {
      needed += this->skipped;
      most = found * Inflater::mostPerByte;
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
          (this->encoding == VoxelEncoding::Compressed
              ? "compressed data"
              : (this->encoding == VoxelEncoding::Text ? "text" : "data")) +
          ", but its header promises " + std::to_string(needed) +
          (this->encoding == VoxelEncoding::Text ? " values" : ""));
    }
  }
}

PlainVoxelReader::PlainVoxelReader(PlainVoxels voxels)
  : Voxels(std::move(voxels))
  , Bytes(VoxelBytes::open(this->Voxels))
{
}

void PlainVoxelReader::read(int first, std::span<unsigned char> values)
{
  const std::uint64_t valueSize = this->Voxels.valueSize();
  const std::uint64_t sliceSize = this->Voxels.sliceValues() * valueSize;
  const auto components = static_cast<std::uint64_t>(this->Voxels.components);
  std::uint64_t position = static_cast<std::uint64_t>(first) * sliceSize * components;
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

} // namespace ink::cli
