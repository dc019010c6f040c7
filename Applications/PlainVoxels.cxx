#include "PlainVoxels.h"

#include "ReadFile.h"
#include "TextHeader.h"

#include "vtkByteSwap.h"
#include "vtkDataArray.h"
#include "vtkMetaImageReader.h"
#include "vtkNrrdReader.h"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

#include <fcntl.h>

namespace fs = std::filesystem;

namespace ink::cli
{
namespace
{

using Fields = std::map<std::string, std::string>;

std::string fieldOf(const Fields& fields, const char* name, const char* otherName = "")
{
  for (const char* key : { name, otherName })
  {
    if (const auto found = fields.find(key); found != fields.end())
    {
      return found->second;
    }
  }
  return "";
}

/// As MetaImage writes it: True or 1.
bool isTrue(const std::string& text)
{
  return !text.empty() && (text[0] == 'T' || text[0] == 't' || text[0] == '1');
}

/// What the reader found in the header.
PlainVoxels fromReader(vtkImageReader2* reader)
{
  PlainVoxels voxels;
  const int* extent = reader->GetDataExtent();
  for (int i = 0; i < 3; ++i)
  {
    voxels.dimensions[i] = extent[2 * i + 1] - extent[2 * i] + 1;
  }
  voxels.type = reader->GetDataScalarType();
  voxels.components = reader->GetNumberOfScalarComponents();
  return voxels;
}

/// One file beside the header, if the name is that of one.
std::optional<fs::path> besides(const fs::path& header, const std::string& name)
{
  const fs::path data = header.parent_path() / name;
  std::error_code error;
  return !name.empty() && fs::is_regular_file(data, error) ? std::optional(data) : std::nullopt;
}

void requireSize(const fs::path& file, const PlainVoxels& voxels)
{
  const std::uint64_t size = fs::file_size(voxels.file);
  const std::uint64_t found = size - std::min(size, voxels.offset);
  if (found < voxels.fileBytes())
  {
    failToRead(file,
      "it has " + std::to_string(found) + " bytes of data, but its header promises " +
        std::to_string(voxels.fileBytes()));
  }
}

} // namespace

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

std::optional<PlainVoxels> findNrrdVoxels(const fs::path& file, vtkNrrdReader* reader)
{
  std::streamoff headerSize = 0;
  const Fields fields = readTextHeader(file, ':', "", &headerSize);
  if (fieldOf(fields, "encoding") != "raw")
  {
    return std::nullopt;
  }
  PlainVoxels voxels = fromReader(reader);
  voxels.swapped = voxels.valueSize() > 1 && reader->GetSwapBytes();
  voxels.flipped = !reader->GetFileLowerLeft();
  const std::string detached = fieldOf(fields, "data file", "datafile");
  voxels.file = file;
  voxels.offset = static_cast<std::uint64_t>(headerSize);
  if (!detached.empty())
  {
    const auto data = besides(file, detached);
    if (!data)
    {
      return std::nullopt;
    }
    voxels.file = *data;
    voxels.offset = 0;
  }
  requireSize(file, voxels);
  return voxels;
}

std::optional<PlainVoxels> findMetaImageVoxels(const fs::path& file, vtkMetaImageReader* reader)
{
  std::streamoff headerSize = 0;
  const Fields fields = readTextHeader(file, '=', "ElementDataFile", &headerSize);
  const std::string type = fieldOf(fields, "ElementType");
  // What MET_LONG is depends on who wrote it.
  if (!isTrue(fieldOf(fields, "BinaryData")) || isTrue(fieldOf(fields, "CompressedData")) ||
    type == "MET_LONG" || type == "MET_ULONG")
  {
    return std::nullopt;
  }
  PlainVoxels voxels = fromReader(reader);
  const bool bigEndian = isTrue(fieldOf(fields, "ElementByteOrderMSB", "BinaryDataByteOrderMSB"));
  voxels.swapped = voxels.valueSize() > 1 && bigEndian != (std::endian::native == std::endian::big);
  const std::string name = fieldOf(fields, "ElementDataFile");
  const bool local = name == "LOCAL" || name == "Local" || name == "local";
  voxels.file = file;
  voxels.offset = static_cast<std::uint64_t>(headerSize);
  if (!local)
  {
    const auto data = besides(file, name);
    if (!data)
    {
      return std::nullopt;
    }
    voxels.file = *data;
    voxels.offset = 0;
  }
  // Of the data file; -1: the voxels are its end.
  if (const auto header = numbersIn(fieldOf(fields, "HeaderSize")); !header.empty() && header[0] != 0)
  {
    const std::uint64_t size = fs::file_size(voxels.file);
    voxels.offset =
      header[0] > 0 ? static_cast<std::uint64_t>(header[0]) : size - std::min(size, voxels.fileBytes());
  }
  requireSize(file, voxels);
  return voxels;
}

PlainVoxelReader::PlainVoxelReader(PlainVoxels voxels)
  : Voxels(std::move(voxels))
  , File(open(this->Voxels.file.c_str(), O_RDONLY | O_CLOEXEC))
{
  if (this->File.get() < 0)
  {
    failToRead(this->Voxels.file, std::strerror(errno));
  }
}

void PlainVoxelReader::readBytes(std::uint64_t position, std::span<unsigned char> bytes)
{
  if (readAt(this->File.get(), position, bytes) != bytes.size())
  {
    failToRead(this->Voxels.file, errno ? std::strerror(errno) : "it was cut short while it was read");
  }
}

void PlainVoxelReader::read(int first, std::span<unsigned char> values)
{
  const std::uint64_t valueSize = this->Voxels.valueSize();
  const std::uint64_t sliceSize = this->Voxels.sliceValues() * valueSize;
  const auto components = static_cast<std::uint64_t>(this->Voxels.components);
  std::uint64_t position = this->Voxels.offset + static_cast<std::uint64_t>(first) * sliceSize * components;
  if (components == 1)
  {
    this->readBytes(position, values);
  }
  else
  {
    // A slice at a time: only one component of it is kept.
    std::vector<unsigned char> all(sliceSize * components);
    for (std::size_t begin = 0; begin < values.size(); begin += sliceSize, position += all.size())
    {
      this->readBytes(position, all);
      for (std::uint64_t n = 0; n < this->Voxels.sliceValues(); ++n)
      {
        std::memcpy(&values[begin + n * valueSize], &all[n * components * valueSize], valueSize);
      }
    }
  }
  for (std::size_t begin = 0; begin < values.size(); begin += sliceSize)
  {
    this->finishSlice(&values[begin]);
  }
}

void PlainVoxelReader::finishSlice(unsigned char* slice) const
{
  if (this->Voxels.swapped)
  {
    vtkByteSwap::SwapVoidRange(slice, this->Voxels.sliceValues(), this->Voxels.valueSize());
  }
  if (this->Voxels.flipped)
  {
    const std::uint64_t row =
      static_cast<std::uint64_t>(this->Voxels.dimensions[0]) * this->Voxels.valueSize();
    for (int top = 0, bottom = this->Voxels.dimensions[1] - 1; top < bottom; ++top, --bottom)
    {
      std::swap_ranges(slice + top * row, slice + (top + 1) * row, slice + bottom * row);
    }
  }
}

} // namespace ink::cli
