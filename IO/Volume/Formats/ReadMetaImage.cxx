// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeHeader.h"

#include "ReadError.h"
#include "TextHeader.h"
#include "Words.h"

#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

/// As MetaImage writes it: True or 1.
bool isTrue(const std::string& text)
{
  return !text.empty() && (text[0] == 'T' || text[0] == 't' || text[0] == '1');
}

class MetaHeader
{
public:
  explicit MetaHeader(const fs::path& file)
    : File(file)
    , Fields(readTextHeader(file, '=', "ElementDataFile", &this->Size))
  {
    for (const char* name : { "NDims", "DimSize", "ElementType", "ElementDataFile" })
    {
      if (this->field(name).empty())
      {
        failToRead(file, std::string("it is not a MetaImage volume: its header has no field '") + name + "'");
      }
    }
    const std::string object = this->field("ObjectType");
    if (!object.empty() && object != "Image")
    {
      this->fail("ObjectType", "Image");
    }
  }

  std::uint64_t size() const { return static_cast<std::uint64_t>(this->Size); }
  std::string field(const char* name, const char* otherName = "") const
  {
    return fieldOf(this->Fields, name, otherName);
  }
  std::vector<double> numbers(const char* name, const char* otherName = "") const
  {
    return numbersIn(this->field(name, otherName));
  }
  /// Of one of three names that the format has had.
  std::vector<double> numbers(const char* name, const char* otherName, const char* thirdName) const
  {
    return this->numbers(this->field(name).empty() ? otherName : name, thirdName);
  }

  [[noreturn]] void fail(const char* name, const std::string& expected) const
  {
    failToRead(this->File,
      std::string("its header says ") + name + " '" + shortened(this->field(name)) + "'; expected " +
        expected);
  }

  /// A whole number from least on.
  int integer(const char* name, double number, double least) const
  {
    if (!(number >= least && number <= std::numeric_limits<int>::max() && number == std::floor(number)))
    {
      this->fail(name, "whole numbers that a file can hold");
    }
    return static_cast<int>(number);
  }

private:
  const fs::path& File;
  std::streamoff Size = 0;
  TextFields Fields;
};

int typeOf(const MetaHeader& meta)
{
  static const std::map<std::string_view, int> types{ { "MET_CHAR", VTK_SIGNED_CHAR },
    { "MET_UCHAR", VTK_UNSIGNED_CHAR }, { "MET_SHORT", VTK_SHORT }, { "MET_USHORT", VTK_UNSIGNED_SHORT },
    { "MET_INT", VTK_INT }, { "MET_UINT", VTK_UNSIGNED_INT }, { "MET_LONG", VTK_INT },
    { "MET_ULONG", VTK_UNSIGNED_INT }, { "MET_LONG_LONG", VTK_LONG_LONG },
    { "MET_ULONG_LONG", VTK_UNSIGNED_LONG_LONG }, { "MET_FLOAT", VTK_FLOAT }, { "MET_DOUBLE", VTK_DOUBLE } };
  std::string name = meta.field("ElementType");
  if (const auto array = name.find("_ARRAY"); array != std::string::npos)
  {
    name.erase(array);
  }
  const auto type = types.find(name);
  if (type == types.end())
  {
    meta.fail("ElementType", "a type as MET_UCHAR, MET_SHORT or MET_FLOAT");
  }
  return type->second;
}

/// Where in which files the voxels lie, after all else about them is known.
void findData(const MetaHeader& meta, const fs::path& file, RawVolume& voxels)
{
  const std::string name = meta.field("ElementDataFile");
  const bool local = name == "LOCAL" || name == "Local" || name == "local";
  voxels.files = local ? std::vector{ file } : detachedFiles(file, name, voxels.dimensions[2]);
  voxels.offset = local ? meta.size() : 0;
  // -1: the voxels are the end of the file.
  if (const auto header = meta.numbers("HeaderSize"); !header.empty() && header[0] != 0.0)
  {
    const int given = meta.integer("HeaderSize", header[0], -1.0);
    const std::uint64_t size = fs::file_size(voxels.files.front());
    voxels.offset = given > 0 ? static_cast<std::uint64_t>(given)
                              : size - std::min(size, voxels.fileBytes() / voxels.files.size());
  }
  if (voxels.files.size() > 1 && voxels.encoding != VoxelEncoding::Plain)
  {
    meta.fail("ElementDataFile", "uncompressed voxels where they are in several files");
  }
  // MET_LONG has 4 or 8 bytes, depending on who wrote it: only their number tells.
  const bool isLong = meta.field("ElementType").find("LONG") != std::string::npos;
  if (isLong && (voxels.type == VTK_INT || voxels.type == VTK_UNSIGNED_INT))
  {
    const std::uint64_t size = fs::file_size(voxels.files.front());
    const std::uint64_t found = (size - std::min(size, voxels.offset)) * voxels.files.size();
    if (voxels.encoding != VoxelEncoding::Plain)
    {
      meta.fail("ElementType", "MET_INT or MET_LONG_LONG, whose size is known");
    }
    if (found >= 2 * voxels.fileBytes())
    {
      voxels.type = voxels.type == VTK_INT ? VTK_LONG_LONG : VTK_UNSIGNED_LONG_LONG;
    }
  }
}

} // namespace

VolumeHeader readMetaImageHeader(const fs::path& file)
{
  const MetaHeader meta(file);
  VolumeHeader header;
  header.format = "MetaImage volume";
  RawVolume& voxels = header.voxels;
  voxels.type = typeOf(meta);

  const auto dimension = meta.numbers("NDims");
  const auto sizes = meta.numbers("DimSize");
  if (dimension.size() != 1 || (dimension[0] != 2.0 && dimension[0] != 3.0) ||
    static_cast<double>(sizes.size()) != dimension[0])
  {
    failToRead(file,
      "its header says NDims '" + shortened(meta.field("NDims")) + "' and DimSize '" +
        shortened(meta.field("DimSize")) + "'; expected 3 numbers, or 2");
  }
  std::fill_n(voxels.dimensions, 3, 1);
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    voxels.dimensions[i] = meta.integer("DimSize", sizes[i], 1.0);
  }
  if (const auto channels = meta.numbers("ElementNumberOfChannels"); !channels.empty())
  {
    voxels.components = meta.integer("ElementNumberOfChannels", channels[0], 1.0);
  }
  header.components = voxels.components;
  const std::string binary = meta.field("BinaryData");
  if (!binary.empty() && !isTrue(binary))
  {
    voxels.encoding = VoxelEncoding::Text;
  }
  else
  {
    voxels.encoding = isTrue(meta.field("CompressedData")) ? VoxelEncoding::Compressed : VoxelEncoding::Plain;
    voxels.setBigEndian(isTrue(meta.field("ElementByteOrderMSB", "BinaryDataByteOrderMSB")));
  }
  voxels.checkDimensions(file);
  findData(meta, file, voxels);
  voxels.check(file);

  const auto spacing = meta.numbers("ElementSpacing", "ElementSize");
  for (std::size_t i = 0; i < std::min<std::size_t>(spacing.size(), 3); ++i)
  {
    header.spacing[i] = spacingOf(spacing[i]);
  }
  const auto origin = meta.numbers("Offset", "Position", "Origin");
  std::copy_n(origin.begin(), std::min<std::size_t>(origin.size(), 3), header.origin);
  const auto steps = meta.numbers("TransformMatrix", "Rotation", "Orientation");
  constexpr std::size_t threeVectors = 9;
  if (steps.size() == threeVectors)
  {
    constexpr double sign[3] = { 1, 1, 1 };
    header.orientation.emplace(steps.data(), header.origin, sign);
  }
  else if (!steps.empty() && sizes.size() == 3)
  {
    meta.fail("TransformMatrix", "nine numbers");
  }
  return header;
}

} // namespace ink::io
