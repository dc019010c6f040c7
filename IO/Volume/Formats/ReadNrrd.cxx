// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeHeader.h"

#include "ReadError.h"
#include "TextHeader.h"
#include "Words.h"

#include "vtkMath.h"
#include "vtkType.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <string_view>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

int nrrdTypeOf(const std::string& name)
{
  static const std::map<std::string_view, int> types{ { "signed char", VTK_SIGNED_CHAR },
    { "int8", VTK_SIGNED_CHAR }, { "int8_t", VTK_SIGNED_CHAR }, { "uchar", VTK_UNSIGNED_CHAR },
    { "unsigned char", VTK_UNSIGNED_CHAR }, { "uint8", VTK_UNSIGNED_CHAR }, { "uint8_t", VTK_UNSIGNED_CHAR },
    { "short", VTK_SHORT }, { "short int", VTK_SHORT }, { "signed short", VTK_SHORT },
    { "signed short int", VTK_SHORT }, { "int16", VTK_SHORT }, { "int16_t", VTK_SHORT },
    { "ushort", VTK_UNSIGNED_SHORT }, { "unsigned short", VTK_UNSIGNED_SHORT },
    { "unsigned short int", VTK_UNSIGNED_SHORT }, { "uint16", VTK_UNSIGNED_SHORT },
    { "uint16_t", VTK_UNSIGNED_SHORT }, { "int", VTK_INT }, { "signed int", VTK_INT }, { "int32", VTK_INT },
    { "int32_t", VTK_INT }, { "uint", VTK_UNSIGNED_INT }, { "unsigned int", VTK_UNSIGNED_INT },
    { "uint32", VTK_UNSIGNED_INT }, { "uint32_t", VTK_UNSIGNED_INT }, { "longlong", VTK_LONG_LONG },
    { "long long", VTK_LONG_LONG }, { "long long int", VTK_LONG_LONG }, { "signed long long", VTK_LONG_LONG },
    { "signed long long int", VTK_LONG_LONG }, { "int64", VTK_LONG_LONG }, { "int64_t", VTK_LONG_LONG },
    { "ulonglong", VTK_UNSIGNED_LONG_LONG }, { "unsigned long long", VTK_UNSIGNED_LONG_LONG },
    { "unsigned long long int", VTK_UNSIGNED_LONG_LONG }, { "uint64", VTK_UNSIGNED_LONG_LONG },
    { "uint64_t", VTK_UNSIGNED_LONG_LONG }, { "float", VTK_FLOAT }, { "double", VTK_DOUBLE } };
  const auto type = types.find(name);
  return type == types.end() ? VTK_VOID : type->second;
}

/// The words of a header that are read more than once.
class NrrdHeader
{
public:
  explicit NrrdHeader(const fs::path& file)
    : File(file)
  {
    for (const auto& [name, value] : readTextHeader(file, ':', "", &this->Size))
    {
      this->Fields[vtksys::SystemTools::LowerCase(name)] = value;
    }
    std::string magic(4, ' ');
    std::ifstream(file, std::ios::binary).read(magic.data(), 4);
    if (magic != "NRRD")
    {
      failToRead(file, "it is not a NRRD volume: it does not begin with NRRD");
    }
    for (const char* name : { "type", "dimension", "sizes", "encoding" })
    {
      if (this->field(name).empty())
      {
        failToRead(file, std::string("its header has no field '") + name + "'");
      }
    }
  }

  std::uint64_t size() const { return static_cast<std::uint64_t>(this->Size); }
  std::string field(const char* name, const char* otherName = "") const
  {
    return fieldOf(this->Fields, name, otherName);
  }
  /// One of some words, which may be written in letters of either case.
  std::string choice(const char* name) const { return vtksys::SystemTools::LowerCase(this->field(name)); }

  [[noreturn]] void fail(const char* name, const std::string& expected) const
  {
    failToRead(this->File,
      std::string("its header says ") + name + " '" + shortened(this->field(name)) + "'; expected " +
        expected);
  }

  /// Three or four sizes.
  std::vector<int> sizes() const
  {
    const auto dimension = numbersIn(this->field("dimension"));
    const auto numbers = numbersIn(this->field("sizes"));
    std::vector<int> sizes;
    for (const double number : numbers)
    {
      if (!(number >= 1.0 && number <= std::numeric_limits<int>::max() && number == std::floor(number)))
      {
        this->fail("sizes", "whole numbers of 1 or more that a file can hold");
      }
      sizes.push_back(static_cast<int>(number));
    }
    if (dimension.size() != 1 || (dimension[0] != 3.0 && dimension[0] != 4.0) ||
      static_cast<double>(sizes.size()) != dimension[0])
    {
      failToRead(this->File,
        "its header says dimension '" + shortened(this->field("dimension")) + "' and sizes '" +
          shortened(this->field("sizes")) + "'; expected 3 or 4 sizes");
    }
    return sizes;
  }

  /// Of each axis; NaN for one that is not of space.
  std::vector<double> spacings() const
  {
    const std::string words = this->field("spacings");
    std::string_view rest = words;
    std::vector<double> spacings;
    for (std::string_view word = nextWord(rest); !word.empty(); word = nextWord(rest))
    {
      spacings.push_back(numberIn(word).value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    return spacings;
  }

  /// Three numbers of each axis, but for one of four that is not of space, whose "none" would end the
  /// numbers.
  std::vector<double> directions(std::size_t axes) const
  {
    std::string words = this->choice("space directions");
    if (const auto none = words.find("none"); none != std::string::npos)
    {
      words.erase(none, 4);
    }
    std::vector<double> numbers = numbersIn(words);
    const std::optional<std::size_t> axis = this->axisWithoutDirection(numbers);
    if (axes == 4 && axis)
    {
      const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(3 * *axis);
      numbers.erase(first, first + 3);
    }
    return numbers;
  }

  /// The index of the one axis of four that is not of space: the first, for components, where nothing says
  /// so.
  std::size_t otherAxis() const
  {
    const std::string directions = this->field("space directions");
    const std::vector<double> spacings = this->spacings();
    if (const auto word = directions.find("none"); word != std::string::npos)
    {
      return static_cast<std::size_t>(std::count(directions.begin(), directions.begin() + word, ')'));
    }
    if (const std::optional<std::size_t> axis = this->axisWithoutDirection(numbersIn(directions)))
    {
      return *axis;
    }
    const auto none =
      std::find_if(spacings.begin(), spacings.end(), [](double spacing) { return std::isnan(spacing); });
    return none == spacings.end() ? 0 : static_cast<std::size_t>(none - spacings.begin());
  }

private:
  /// Of four, one whose direction is (0,0,0), as SCIRun writes for "none".
  static std::optional<std::size_t> axisWithoutDirection(const std::vector<double>& numbers)
  {
    for (std::size_t axis = 0; numbers.size() == 12 && axis < 4; ++axis)
    {
      if (std::all_of(&numbers[3 * axis], &numbers[3 * axis] + 3, [](double n) { return n == 0.0; }))
      {
        return axis;
      }
    }
    return std::nullopt;
  }

  const fs::path& File;
  std::streamoff Size = 0;
  TextFields Fields;
};

void setOrientation(const NrrdHeader& nrrd, std::size_t otherAxis, std::size_t axes, VolumeHeader& header)
{
  std::vector<double> spacings = nrrd.spacings();
  if (axes == 4 && spacings.size() == axes)
  {
    spacings.erase(spacings.begin() + static_cast<std::ptrdiff_t>(otherAxis));
  }
  for (std::size_t i = 0; i < std::min<std::size_t>(spacings.size(), 3); ++i)
  {
    header.spacing[i] = spacingOf(spacings[i]);
  }
  const std::vector<double> origin = numbersIn(nrrd.field("space origin"));
  if (!nrrd.field("space origin").empty() && origin.size() != 3)
  {
    nrrd.fail("space origin", "three numbers as (0,0,0)");
  }
  std::copy(origin.begin(), origin.end(), header.origin);

  if (nrrd.field("space directions").empty())
  {
    return;
  }
  const std::vector<double> steps = nrrd.directions(axes);
  constexpr std::size_t threeVectors = 9;
  if (steps.size() != threeVectors)
  {
    nrrd.fail("space directions", "three vectors as (1,0,0) (0,1,0) (0,0,1)");
  }
  const std::string space = nrrd.choice("space");
  const bool towardsRight = space.starts_with("right") || space == "ras";
  const bool towardsFront = space.find("anterior") != std::string::npos || space == "ras" || space == "las";
  const double sign[3] = { towardsRight ? -1.0 : 1.0, towardsFront ? -1.0 : 1.0, 1.0 };
  header.orientation.emplace(steps.data(), header.origin, sign);
  for (int i = 0; i < 3; ++i)
  {
    header.spacing[i] = spacingOf(vtkMath::Norm(steps.data() + 3 * i));
  }
}

} // namespace

VolumeHeader readNrrdHeader(const fs::path& file)
{
  const NrrdHeader nrrd(file);
  VolumeHeader header;
  header.format = "NRRD volume";
  RawVolume& voxels = header.voxels;
  voxels.type = nrrdTypeOf(nrrd.choice("type"));
  if (voxels.type == VTK_VOID)
  {
    nrrd.fail("type", "an integer of 8 to 64 bits as uint8, float or double");
  }
  if (nrrd.choice("space").find("time") != std::string::npos)
  {
    nrrd.fail("space", "a space of three dimensions");
  }
  std::vector<int> sizes = nrrd.sizes();
  const std::size_t axes = sizes.size();
  const std::size_t otherAxis = axes == 4 ? nrrd.otherAxis() : 0;
  if (otherAxis != 0 && otherAxis != 3)
  {
    nrrd.fail("sizes", "the axis that is not of space to be the first or the last");
  }
  std::uint64_t volumes = 1;
  if (axes == 4)
  {
    const int other = sizes[otherAxis];
    sizes.erase(sizes.begin() + static_cast<std::ptrdiff_t>(otherAxis));
    (otherAxis == 0 ? voxels.components : header.components) = other;
    volumes = otherAxis == 0 ? 1 : static_cast<std::uint64_t>(other);
  }
  header.components = std::max(header.components, voxels.components);
  std::copy(sizes.begin(), sizes.end(), voxels.dimensions);

  const std::string encoding = nrrd.choice("encoding");
  if (encoding == "gzip" || encoding == "gz")
  {
    voxels.encoding = VoxelEncoding::Compressed;
  }
  else if (encoding == "ascii" || encoding == "text" || encoding == "txt")
  {
    voxels.encoding = VoxelEncoding::Text;
  }
  else if (encoding != "raw")
  {
    nrrd.fail("encoding", "raw, gzip or ascii");
  }
  const std::string endian = nrrd.choice("endian");
  if (!endian.empty() && endian != "little" && endian != "big")
  {
    nrrd.fail("endian", "little or big");
  }
  if (voxels.encoding != VoxelEncoding::Text)
  {
    voxels.setBigEndian(endian == "big");
  }
  for (const auto& [name, otherName] :
    { std::pair("byte skip", "byteskip"), std::pair("line skip", "lineskip") })
  {
    const auto skip = numbersIn(nrrd.field(name, otherName));
    if (!skip.empty() && skip[0] != 0.0)
    {
      nrrd.fail(name, "0");
    }
  }

  const std::string detached = nrrd.field("data file", "datafile");
  voxels.files = detached.empty() ? std::vector{ file } : detachedFiles(file, detached, voxels.dimensions[2]);
  voxels.offset = detached.empty() ? nrrd.size() : 0;
  if (detached.empty() && nrrd.size() == fs::file_size(file))
  {
    failToRead(file, "the file ends within or after its header");
  }
  if (voxels.files.size() > 1 && (voxels.encoding != VoxelEncoding::Plain || volumes > 1))
  {
    nrrd.fail("encoding", "raw for one volume in several files");
  }
  voxels.check(file);
  setOrientation(nrrd, otherAxis, axes, header);
  return header;
}

} // namespace ink::io
