// SPDX-License-Identifier: BSD-3-Clause
// Files of voxels alone, which somebody else knows about: the user, or whoever named them.
#include "VolumeHeader.h"

#include "Core/FormatNumber.h"
#include "FirstBytes.h"
#include "NumberTypes.h"
#include "Pattern.h"
#include "ReadError.h"

#include "vtkSetGet.h"
#include "vtkType.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <type_traits>
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

/// The name of the type that a file's name has, or else that its size leaves.
std::string findType(const std::string& name, const fs::path& file, double voxels)
{
  static const Pattern types(
    "(?:^|[^a-z0-9])(u?int8|u?int16|u?int32|u?int64|float32|float64)(?![a-z0-9])", /*ignoreCase=*/true);
  const std::vector<std::string> said = types.search(name);
  if (!said.empty())
  {
    std::string type = said[1];
    std::transform(type.begin(), type.end(), type.begin(), [](unsigned char c) { return std::tolower(c); });
    return type;
  }
  const auto bytes = static_cast<double>(fs::file_size(file));
  return bytes == voxels ? "uint8" : bytes == 2.0 * voxels ? "uint16" : "";
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
  static const Pattern sizes(
    R"((?:^|[^a-z0-9])(\d{1,6})x(\d{1,6})x(\d{1,6})(?![a-z0-9]))", /*ignoreCase=*/true);
  const std::vector<std::string> size = sizes.search(name);
  int dimensions[3] = { 0, 0, 0 };
  if (!size.empty())
  {
    std::transform(
      size.begin() + 1, size.end(), dimensions, [](const std::string& digits) { return std::stoi(digits); });
  }
  const double voxels = static_cast<double>(dimensions[0]) * dimensions[1] * dimensions[2];
  const std::string type = voxels > 0.0 ? findType(name, file, voxels) : std::string();
  if (type.empty())
  {
    failToRead(file,
      "its name does not say what is in it; expected one such as skull_256x256x256_uint8.raw, or Raw "
      "(--raw)");
  }
  VolumeHeader header = rawHeader(file, dimensions, numberTypes().at(type), /*bigEndian=*/false);
  header.notes.push_back("what is in it is taken from its name: " + formatDimensions(dimensions) + " " +
    type + (header.voxels.valueSize() > 1 ? ", little endian" : ""));
  return header;
}

} // namespace ink::io
