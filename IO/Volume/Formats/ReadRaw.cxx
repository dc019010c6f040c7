// SPDX-License-Identifier: BSD-3-Clause
// Files of voxels alone, which somebody else knows about: the user, or whoever named them.
#include "VolumeHeader.h"

#include "Core/FormatNumber.h"
#include "FirstBytes.h"
#include "NumberTypes.h"
#include "Pattern.h"
#include "ReadError.h"

#include "vtkDataArray.h"
#include "vtkSetGet.h"
#include "vtkType.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

/// Whether values of a type of VTK's have bytes of their own and can be computed with: bits and strings not.
bool IsNumber(int type)
{
  switch (type)
  {
    vtkTemplateMacro(return std::is_arithmetic_v<VTK_TT>);
    default:
      return false;
  }
}

/// All parts of a text that an expression matches, each with its groups, in lower case.
std::vector<std::vector<std::string>> findAll(const Pattern& pattern, std::string text)
{
  text = vtksys::SystemTools::LowerCase(text);
  std::vector<std::vector<std::string>> found;
  for (std::vector<std::string> match = pattern.search(text); !match.empty(); match = pattern.search(text))
  {
    text = text.substr(text.find(match[0]) + match[0].size());
    found.push_back(std::move(match));
  }
  return found;
}

using Dimensions = std::array<int, 3>;

/// All that a name says of sizes, as 256x256x128.
std::vector<Dimensions> findDimensions(const std::string& name)
{
  // A dot before it may be a decimal's.
  static const Pattern sizes(R"((?:^|[^a-z0-9.]|[^0-9]\.)(\d{1,6})x(\d{1,6})x(\d{1,6})(?![a-z0-9]))");
  std::vector<Dimensions> found;
  for (const std::vector<std::string>& match : findAll(sizes, name))
  {
    found.push_back({ std::stoi(match[1]), std::stoi(match[2]), std::stoi(match[3]) });
  }
  return found;
}

double countVoxels(const Dimensions& dimensions)
{
  return static_cast<double>(dimensions[0]) * dimensions[1] * dimensions[2];
}

double bytesOf(const std::string& type)
{
  return vtkDataArray::GetDataTypeSize(numberTypes().at(type));
}

/// What a name says of its voxels' type.
struct NamedType
{
  std::string name; ///< empty: nothing
  bool bigEndian = false;
};

/// @param bytesPerVoxel that the file has; 0: not known
/// @throws ReadError for types that are none of numberTypes(), as float16, and for two types
NamedType findType(const std::string& name, const fs::path& file, double bytesPerVoxel)
{
  static const Pattern types(
    "(?:^|[^a-z0-9])((?:u?int|float)\\d+|half|complex\\d*|rgba?\\d*)(le|be)?(?![a-z0-9])");
  static const Pattern bigEndian("(?:^|[^a-z])(big.?endian|msb|be)(?![a-z])");
  NamedType type{ "", !findAll(bigEndian, name).empty() };
  for (const std::vector<std::string>& said : findAll(types, name))
  {
    if (!numberTypes().contains(said[1]) || (!type.name.empty() && type.name != said[1]))
    {
      failToRead(file,
        "its name says '" + said[1] + "'" + (type.name.empty() ? "" : " and '" + type.name + "'") +
          "; expected one of " + listNumberTypes());
    }
    type.name = said[1];
    type.bigEndian = type.bigEndian || said[2] == "be";
  }
  if (!type.name.empty() || bytesPerVoxel == 0.0)
  {
    return type;
  }
  // Words that mean other things, too, count where they fit.
  static const std::map<std::string, std::string> words{ { "byte", "uint8" }, { "uchar", "uint8" },
    { "char", "int8" }, { "ushort", "uint16" }, { "short", "int16" }, { "uint", "uint32" },
    { "int", "int32" }, { "float", "float32" }, { "double", "float64" } };
  static const Pattern word("(?:^|[^a-z0-9])(u?char|byte|u?short|u?int|float|double)(?![a-z0-9])");
  for (const std::vector<std::string>& said : findAll(word, name))
  {
    const std::string& meant = words.at(said[1]);
    type.name = bytesOf(meant) == bytesPerVoxel ? meant : type.name;
  }
  if (type.name.empty())
  {
    type.name = bytesPerVoxel == 1.0 ? "uint8" : bytesPerVoxel == 2.0 ? "uint16" : "";
  }
  return type;
}

} // namespace

VolumeHeader rawHeader(const fs::path& file, const int dimensions[3], int type, bool bigEndian)
{
  VolumeHeader header;
  header.format = "raw volume";
  header.voxels.files = { file };
  std::copy_n(dimensions, 3, header.voxels.dimensions);
  header.voxels.type = type;
  if (!IsNumber(type))
  {
    failToRead(file,
      "RawScalarType is " + std::to_string(type) +
        "; expected integers of 8 to 64 bits, float or double, as VTK_UNSIGNED_CHAR");
  }
  if (std::any_of(dimensions, dimensions + 3, [](int dimension) { return dimension < 1; }))
  {
    failToRead(file, "RawDimensions are " + formatDimensions(dimensions) + "; expected numbers of 1 or more");
  }
  header.voxels.setBigEndian(bigEndian);
  // In double first, in which nothing overflows.
  const double bytes =
    static_cast<double>(header.voxels.valueSize()) * dimensions[0] * dimensions[1] * dimensions[2];
  constexpr double mostBytes = 0x1p63;
  const std::uint64_t found = fs::file_size(file);
  const bool fits = bytes < mostBytes && found == header.voxels.fileBytes();
  if (!fits && bytes < mostBytes && FirstBytes(file, 1).compressed)
  {
    header.format = "compressed raw volume";
    header.voxels.encoding = VoxelEncoding::Compressed;
  }
  else if (!fits)
  {
    failToRead(file,
      "it has " + std::to_string(found) + " bytes, but " + formatDimensions(dimensions) + " " +
        vtkImageScalarTypeNameMacro(type) + " needs " +
        (bytes < mostBytes ? std::to_string(header.voxels.fileBytes()) : formatNumber(bytes)));
  }
  return header;
}

VolumeHeader readNamedRawHeader(const fs::path& file)
{
  const std::string name = file.filename().string();
  const std::vector<Dimensions> sizes = findDimensions(name);
  // Compressed, a file's size says nothing.
  const double bytes = FirstBytes(file, 1).compressed ? 0.0 : static_cast<double>(fs::file_size(file));
  const double voxels = sizes.empty() ? 0.0 : countVoxels(sizes.front());
  const NamedType type = findType(name, file, voxels > 0.0 ? bytes / voxels : 0.0);
  if (type.name.empty() || voxels == 0.0)
  {
    failToRead(file,
      "its name does not say what is in it; expected one such as skull_256x256x256_uint8.raw, or Raw "
      "(--raw)");
  }
  // A name may tell of other sizes, too.
  const auto fitting = std::find_if(sizes.begin(), sizes.end(),
    [&](const Dimensions& size) { return countVoxels(size) * bytesOf(type.name) == bytes; });
  const Dimensions& size = fitting == sizes.end() ? sizes.front() : *fitting;
  VolumeHeader header = rawHeader(file, size.data(), numberTypes().at(type.name), type.bigEndian);
  header.notes.push_back("what is in it is taken from its name: " + formatDimensions(size.data()) + " " +
    type.name +
    (header.voxels.valueSize() == 1 ? ""
        : type.bigEndian            ? ", big endian"
                                    : ", little endian"));
  return header;
}

} // namespace ink::io
