// SPDX-License-Identifier: BSD-3-Clause
// Arrays of NumPy: "NEP 1 - A simple file format for NumPy arrays".
#include "VolumeHeader.h"

#include "FirstBytes.h"
#include "OrderedBytes.h"
#include "ReadError.h"
#include "Words.h"

#include "vtkType.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

constexpr std::string_view npyMagic = "\x93NUMPY";
/// As NumPy reads: what is longer is no header of plain numbers.
constexpr std::size_t longestHeader = 10000;

/// What follows a key of the dictionary, without the space before it; empty if it lacks the key.
std::string_view valueOf(std::string_view dictionary, const std::string& key)
{
  const std::size_t found = dictionary.find("'" + key + "':");
  if (found == std::string_view::npos)
  {
    return {};
  }
  const std::string_view rest = dictionary.substr(found + key.size() + 3);
  return rest.substr(std::min(rest.find_first_not_of(' '), rest.size()));
}

/// What is between two characters, of which the first is the first one.
std::string_view within(std::string_view text, char open, char close)
{
  const std::size_t end = text.find(close, 1);
  return text.starts_with(open) && end != std::string_view::npos ? text.substr(1, end - 1)
                                                                 : std::string_view();
}

/// @param type as '<i2', of which the byte order is told already
void setType(std::string_view type, RawVolume& voxels, const fs::path& file)
{
  struct Type
  {
    std::string_view name;
    int type;
    bool halves = false;
  };
  constexpr Type types[] = { { "b1", VTK_UNSIGNED_CHAR }, { "u1", VTK_UNSIGNED_CHAR },
    { "i1", VTK_SIGNED_CHAR }, { "u2", VTK_UNSIGNED_SHORT }, { "i2", VTK_SHORT }, { "u4", VTK_UNSIGNED_INT },
    { "i4", VTK_INT }, { "u8", VTK_UNSIGNED_LONG_LONG }, { "i8", VTK_LONG_LONG }, { "f2", VTK_FLOAT, true },
    { "f4", VTK_FLOAT }, { "f8", VTK_DOUBLE } };
  const auto* const found = std::find_if(std::begin(types), std::end(types),
    [&](const Type& one) { return type.size() == 3 && type.substr(1) == one.name; });
  if (found == std::end(types) || std::string_view("<>|=").find(type.front()) == std::string_view::npos)
  {
    failToRead(file,
      "its values are '" + shortened(type) +
        "'; expected bool, integers of 8 to 64 bits, or floats of 16 to 64");
  }
  voxels.type = found->type;
  voxels.halves = found->halves;
  voxels.setBigEndian(type.front() == '>');
}

/// The numbers of a tuple. @throws ReadError for what is none
std::vector<int> shapeOf(std::string_view tuple, const fs::path& file)
{
  std::vector<int> shape;
  std::string words(tuple);
  std::replace(words.begin(), words.end(), ',', ' ');
  std::string_view rest = words;
  for (std::string_view word = nextWord(rest); !word.empty(); word = nextWord(rest))
  {
    const std::optional<double> number = numberIn(word);
    if (!number || *number < 0.0 || *number > std::numeric_limits<int>::max() ||
      *number != std::floor(*number))
    {
      failToRead(file, "its shape is (" + shortened(tuple) + "); expected three numbers");
    }
    shape.push_back(static_cast<int>(*number));
  }
  return shape;
}

} // namespace

VolumeHeader readNpyHeader(const fs::path& file)
{
  const auto [compressed, bytes] = FirstBytes(file, longestHeader);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  constexpr std::size_t version = npyMagic.size();
  const std::size_t begin = text.size() > version && text[version] == 1 ? version + 4 : version + 6;
  if (!text.starts_with(npyMagic) || text.size() < begin)
  {
    failToRead(file, "it is no array of NumPy, which begins with \\x93NUMPY");
  }
  const bool swap = std::endian::native == std::endian::big;
  const std::size_t length = begin == version + 4
    ? valueFrom<std::uint16_t>(bytes.data() + version + 2, swap)
    : valueFrom<std::uint32_t>(bytes.data() + version + 2, swap);
  if (length > longestHeader - begin)
  {
    failToRead(file,
      "its header has " + std::to_string(length) +
        " bytes; expected those of an array of numbers, fewer than " + std::to_string(longestHeader));
  }
  if (length > text.size() - begin)
  {
    failToRead(file, "the file ends before its header of " + std::to_string(length) + " bytes does");
  }
  const std::string_view dictionary = text.substr(begin, length);
  VolumeHeader header;
  header.format = "NumPy array";
  RawVolume& voxels = header.voxels;
  voxels.files = { file };
  (compressed ? voxels.skipped : voxels.offset) = begin + length;
  voxels.encoding = compressed ? VoxelEncoding::Compressed : VoxelEncoding::Plain;
  setType(within(valueOf(dictionary, "descr"), '\'', '\''), voxels, file);
  std::vector<int> shape = shapeOf(within(valueOf(dictionary, "shape"), '(', ')'), file);
  const bool isFortran = valueOf(dictionary, "fortran_order").starts_with("True");
  // Of C's order the last axis is the fastest.
  if (!isFortran)
  {
    std::reverse(shape.begin(), shape.end());
  }
  constexpr int mostComponents = 4;
  const auto components = isFortran || shape.empty() ? shape.end() - !shape.empty() : shape.begin();
  const bool hasComponents = shape.size() == 4 && *components <= mostComponents;
  if (shape.size() != 3 && !hasComponents)
  {
    failToRead(file,
      "its array has " + std::to_string(shape.size()) +
        " axes; expected three, of z, y and x, or a fourth one of up to 4 components");
  }
  if (hasComponents && !isFortran && voxels.halves)
  {
    failToRead(file, "its components are of float16; expected one component, or another type");
  }
  if (hasComponents)
  {
    header.components = *components;
    // In Fortran's order each has a block of its own.
    voxels.components = isFortran ? 1 : header.components;
    shape.erase(components);
  }
  std::copy_n(shape.begin(), 3, voxels.dimensions);
  voxels.check(file);
  return header;
}

} // namespace ink::io
