// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeHeader.h"

#include "Core/FormatNumber.h"
#include "ReadError.h"
#include "TextHeader.h"
#include "Words.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <map>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

constexpr int bits = VTK_BIT;

int legacyTypeOf(const std::string& name)
{
  // As VTK writes them on machines of 64 bits, but for ids, which have 32 in these files.
  static const std::map<std::string, int> types{ { "bit", bits }, { "char", VTK_SIGNED_CHAR },
    { "signed_char", VTK_SIGNED_CHAR }, { "unsigned_char", VTK_UNSIGNED_CHAR }, { "short", VTK_SHORT },
    { "unsigned_short", VTK_UNSIGNED_SHORT }, { "int", VTK_INT }, { "unsigned_int", VTK_UNSIGNED_INT },
    { "long", VTK_LONG_LONG }, { "unsigned_long", VTK_UNSIGNED_LONG_LONG }, { "vtkidtype", VTK_INT },
    { "vtktypeint64", VTK_LONG_LONG }, { "vtktypeuint64", VTK_UNSIGNED_LONG_LONG }, { "float", VTK_FLOAT },
    { "double", VTK_DOUBLE } };
  const auto type = types.find(name);
  return type == types.end() ? VTK_VOID : type->second;
}

/// Values in the file, one block.
struct Block
{
  std::string name;
  std::string typeName;
  double components = 1;
  double tuples = 0;
};

/// The values of points, or of cells, that are used.
struct Chosen
{
  bool found = false;
  bool scalars = false;
  Block block;
  int type = VTK_VOID;
  std::streamoff begin = 0; ///< in the file
  double tuples = 0;        ///< that the points, or the cells, should have
};

/// Reads structured points, or a rectilinear or structured grid, up to the values that are used: the first
/// SCALARS of points, else the first others; where points have none, those of cells, as voxels in the cells'
/// centers.
class LegacyText
{
public:
  explicit LegacyText(const fs::path& file)
    : File(file)
    , Stream(file, std::ios::binary)
    , Size(static_cast<double>(fs::file_size(file)))
  {
  }

  VolumeHeader read()
  {
    this->readStart();
    std::string word;
    while (!this->OfPoints.scalars && this->tryWord(word))
    {
      if (!this->takeShape(word) && !this->takeCoordinates(word) && !this->takeValues(word))
      {
        this->fail(word, "a keyword as DIMENSIONS, POINT_DATA or SCALARS");
      }
    }
    const Chosen& chosen = this->OfPoints.found ? this->OfPoints : this->OfCells;
    if (!chosen.found)
    {
      failToRead(this->File, "it holds no values, neither at its points nor in its cells");
    }
    this->use(chosen);
    this->Header.voxels.check(this->File);
    this->checkCoordinates();
    return this->Header;
  }

private:
  [[noreturn]] void fail(const std::string& found, const std::string& expected) const
  {
    failAtWord(this->File, found, expected);
  }

  /// In small letters, as the format does not tell them from large ones. @return false at the end
  bool tryWord(std::string& word)
  {
    word.clear();
    this->Stream >> word;
    std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
    return !word.empty();
  }
  std::string word(const char* expected)
  {
    std::string word;
    if (!this->tryWord(word))
    {
      this->fail("", expected);
    }
    return word;
  }
  double number(const char* expected)
  {
    const std::string word = this->word(expected);
    const std::optional<double> number = numberIn(word);
    if (!number || !std::isfinite(*number))
    {
      this->fail(word, expected);
    }
    return *number;
  }
  double whole(double least, const char* expected)
  {
    const double number = this->number(expected);
    if (number < least || number > std::numeric_limits<int>::max() || number != std::floor(number))
    {
      this->fail(std::to_string(number), expected);
    }
    return number;
  }
  void endLine()
  {
    std::string rest;
    std::getline(this->Stream, rest);
  }

  void readStart()
  {
    std::string line;
    std::getline(this->Stream, line);
    if (!line.starts_with("# vtk DataFile Version"))
    {
      failToRead(this->File, "it is not a legacy VTK file: it does not begin with '# vtk DataFile Version'");
    }
    this->endLine();
    const std::string encoding = this->word("ASCII or BINARY");
    if (encoding != "ascii" && encoding != "binary")
    {
      this->fail(encoding, "ASCII or BINARY");
    }
    this->IsText = encoding == "ascii";
    static const std::map<std::string, const char*> kinds{ { "structured_points", "structured points" },
      { "rectilinear_grid", "a rectilinear grid" }, { "structured_grid", "a structured grid" } };
    const std::string keyword = this->word("DATASET");
    this->Kind = keyword == "dataset" ? this->word("a kind of dataset") : keyword;
    const auto kind = kinds.find(this->Kind);
    if (kind == kinds.end())
    {
      failToRead(this->File,
        "it is not a legacy VTK file of a volume: it says '" + shortened(this->Kind) +
          "'; expected DATASET STRUCTURED_POINTS, RECTILINEAR_GRID or STRUCTURED_GRID, or STRUCTURED_POINTS, "
          "which ParaView's filter Resample To Image makes of other grids");
    }
    this->Header.format = std::string("legacy VTK file of ") + kind->second;
  }

  /// @return whether keyword is one that says where the voxels lie
  bool takeShape(const std::string& keyword)
  {
    if (keyword == "dimensions")
    {
      for (int& dimension : this->Header.voxels.dimensions)
      {
        dimension = static_cast<int>(this->whole(1, "a number of voxels of 1 or more"));
      }
      this->Header.voxels.type = VTK_UNSIGNED_CHAR;
      this->Header.voxels.checkDimensions(this->File);
    }
    else if (keyword == "spacing" || keyword == "aspect_ratio")
    {
      for (double& spacing : this->Header.spacing)
      {
        spacing = spacingOf(this->number("a distance between voxels"));
      }
    }
    else if (keyword == "origin")
    {
      for (double& origin : this->Header.origin)
      {
        origin = this->number("the position of the first voxel");
      }
    }
    else if (keyword == "cell_data" || keyword == "point_data")
    {
      this->In = keyword == "point_data" ? &this->OfPoints : &this->OfCells;
      this->Tuples = this->whole(0, "a number of values");
      const auto voxels =
        static_cast<double>(this->Header.voxels.sliceValues()) * this->Header.voxels.dimensions[2];
      if (this->In == &this->OfPoints && this->Tuples != voxels)
      {
        this->fail(std::to_string(static_cast<std::int64_t>(this->Tuples)),
          "the number of all voxels, " + std::to_string(static_cast<std::int64_t>(voxels)) + ",");
      }
      this->endLine();
    }
    else if (keyword == "metadata")
    {
      // Up to an empty line.
      std::string line;
      this->endLine();
      while (std::getline(this->Stream, line) && line.find_first_not_of(" \t\r") != std::string::npos)
      {
      }
    }
    else
    {
      return false;
    }
    return true;
  }

  /// @return whether keyword is one that coordinates of a grid follow
  bool takeCoordinates(const std::string& keyword)
  {
    static const std::map<std::string, std::string> kinds{ { "x_coordinates", "rectilinear_grid" },
      { "y_coordinates", "rectilinear_grid" }, { "z_coordinates", "rectilinear_grid" },
      { "points", "structured_grid" } };
    const auto kind = kinds.find(keyword);
    if (kind == kinds.end() || kind->second != this->Kind)
    {
      return false;
    }
    const int* dimensions = this->Header.voxels.dimensions;
    const bool arePoints = keyword == "points";
    std::vector<RawVolume>& all = this->Header.coordinates;
    const double expected = arePoints ? static_cast<double>(this->Header.voxels.sliceValues()) * dimensions[2]
                                      : dimensions[keyword.front() - 'x'];
    const double found = this->whole(0, "a number of coordinates");
    const std::string typeName = this->word("a type");
    this->endLine();
    const int type = legacyTypeOf(typeName);
    const std::size_t place = arePoints ? 0 : static_cast<std::size_t>(keyword.front() - 'x');
    if (found != expected || place != all.size() || type == VTK_VOID || type == bits)
    {
      failToRead(this->File,
        "it has " + formatNumber(found) + " " + keyword + " of type '" + shortened(typeName) +
          "'; expected " + formatNumber(expected) +
          " numbers as float, as many as its DIMENSIONS say, and those along x first");
    }
    RawVolume coordinates;
    constexpr int perPoint = 3;
    coordinates.dimensions[0] = arePoints ? perPoint * dimensions[0] : dimensions[place];
    coordinates.dimensions[1] = arePoints ? dimensions[1] : 1;
    coordinates.dimensions[2] = arePoints ? dimensions[2] : 1;
    this->place(coordinates, type, this->Stream.tellg());
    all.push_back(coordinates);
    this->skip(found * (arePoints ? perPoint : 1), type);
    return true;
  }

  void checkCoordinates() const
  {
    const std::size_t expected =
      this->Kind == "structured_points" ? 0 : (this->Kind == "rectilinear_grid" ? 3 : 1);
    if (this->Header.coordinates.size() != expected)
    {
      failToRead(this->File,
        "it does not say where its points are: expected " +
          std::string(expected == 1 ? "POINTS" : "X_COORDINATES, Y_COORDINATES and Z_COORDINATES"));
    }
    for (const RawVolume& coordinates : this->Header.coordinates)
    {
      coordinates.check(this->File);
    }
  }

  void place(RawVolume& values, int type, std::streamoff begin) const
  {
    values.type = type;
    values.files = { this->File };
    values.offset = static_cast<std::uint64_t>(std::max<std::streamoff>(begin, 0));
    values.encoding = this->IsText ? VoxelEncoding::Text : VoxelEncoding::Plain;
    if (!this->IsText)
    {
      values.setBigEndian(true);
    }
  }

  /// @return whether keyword is one that values follow
  bool takeValues(const std::string& keyword)
  {
    static const std::map<std::string, double> others{ { "vectors", 3 }, { "normals", 3 }, { "tensors", 9 },
      { "tensors6", 6 }, { "global_ids", 1 }, { "pedigree_ids", 1 }, { "edge_flags", 1 } };
    if (keyword == "field")
    {
      this->takeField();
      return true;
    }
    Block block;
    block.tuples = this->Tuples;
    block.name = this->word("a name");
    if (keyword == "scalars")
    {
      block.typeName = this->word("a type");
      std::string line;
      std::getline(this->Stream, line);
      std::string_view words = line;
      const std::string_view count = nextWord(words);
      block.components = count.empty() ? 1.0 : numberIn(count).value_or(0.0);
      const std::streampos before = this->Stream.tellg();
      if (this->word("LOOKUP_TABLE") == "lookup_table")
      {
        this->endLine();
      }
      else
      {
        this->Stream.seekg(before);
      }
    }
    else if (keyword == "color_scalars" || keyword == "texture_coordinates")
    {
      block.components = this->whole(1, "a number of components");
      block.typeName =
        keyword == "color_scalars" ? (this->IsText ? "float" : "unsigned_char") : this->word("a type");
      this->endLine();
    }
    else if (keyword == "lookup_table")
    {
      block.tuples = this->whole(0, "a number of colors");
      block.components = 4;
      block.typeName = this->IsText ? "float" : "unsigned_char";
      this->endLine();
    }
    else if (const auto other = others.find(keyword); other != others.end())
    {
      block.components = other->second;
      block.typeName = this->word("a type");
      this->endLine();
    }
    else
    {
      return false;
    }
    this->take(block, keyword != "lookup_table", keyword == "scalars");
    return true;
  }

  void takeField()
  {
    this->word("a name");
    const double count = this->whole(0, "a number of arrays");
    for (double i = 0; i < count; ++i)
    {
      Block block;
      block.name = this->word("a name");
      if (block.name == "metadata")
      {
        this->takeShape(block.name);
        block.name = this->word("a name");
      }
      block.components = this->whole(0, "a number of components");
      block.tuples = this->whole(0, "a number of values");
      block.typeName = this->word("a type");
      this->endLine();
      this->take(block, true, false);
    }
  }

  /// Uses the values that begin here, or goes past them.
  void take(const Block& block, bool areValues, bool areScalars)
  {
    const int type = legacyTypeOf(block.typeName);
    constexpr double mostComponents = 1 << 20;
    if (type == VTK_VOID || !(block.components >= 0 && block.components <= mostComponents) ||
      block.components != std::floor(block.components))
    {
      failToRead(this->File,
        "its array '" + shortened(block.name) + "' has type '" + shortened(block.typeName) + "' and " +
          std::to_string(block.components) +
          " components; expected numbers as float, and 1 component or more");
    }
    const bool isUsed = areValues && this->In && block.tuples == this->Tuples && block.components > 0 &&
      (!this->In->found || (areScalars && !this->In->scalars));
    const std::streamoff begin = this->Stream.tellg();
    if (isUsed && begin < 0)
    {
      failToRead(
        this->File, "the file ends where the values of '" + shortened(block.name) + "' were expected");
    }
    if (isUsed)
    {
      *this->In = { true, areScalars, block, type, begin, this->Tuples };
      if (this->OfPoints.scalars)
      {
        return;
      }
    }
    this->skip(block.tuples * block.components, type);
  }

  void use(const Chosen& chosen)
  {
    if (chosen.type == bits)
    {
      failToRead(
        this->File, "its voxels are single bits; expected integers of 8 to 64 bits, float or double");
    }
    RawVolume& voxels = this->Header.voxels;
    if (&chosen == &this->OfCells)
    {
      this->moveToCells();
    }
    this->place(voxels, chosen.type, chosen.begin);
    voxels.components = static_cast<int>(chosen.block.components);
    this->Header.components = voxels.components;
    if (!chosen.scalars)
    {
      this->Header.notes.push_back("array '" + chosen.block.name + "' is used");
    }
  }

  /// Voxels in place of the points between which the cells are.
  void moveToCells()
  {
    double cells = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      int& dimension = this->Header.voxels.dimensions[axis];
      if (dimension > 1)
      {
        --dimension;
        this->Header.origin[axis] += 0.5 * this->Header.spacing[axis];
      }
      cells *= dimension;
    }
    if (this->OfCells.tuples != cells)
    {
      this->fail(std::to_string(static_cast<std::int64_t>(this->OfCells.tuples)),
        "the number of all cells, " + std::to_string(static_cast<std::int64_t>(cells)) + ",");
    }
    this->Header.notes.emplace_back(noteOfCells);
  }

  void skip(double values, int type)
  {
    if (values > this->Size * 8)
    {
      failToRead(this->File, "the file ends within an array that it promises");
    }
    if (!this->IsText)
    {
      constexpr double bitsOfAByte = 8;
      const double bytes = type == bits ? std::ceil(values / bitsOfAByte)
                                        : values * static_cast<double>(vtkDataArray::GetDataTypeSize(type));
      this->Stream.seekg(static_cast<std::streamoff>(bytes), std::ios::cur);
      if (!this->Stream || static_cast<double>(this->Stream.tellg()) > this->Size)
      {
        failToRead(this->File, "the file ends within an array that it promises");
      }
      return;
    }
    for (double i = 0; i < values; ++i)
    {
      this->number("a value");
    }
  }

  const fs::path& File;
  std::ifstream Stream;
  double Size;
  bool IsText = false;
  std::string Kind; ///< of dataset
  Chosen OfPoints;
  Chosen OfCells;
  Chosen* In = nullptr; ///< whose values come next; null: nobody's
  double Tuples = 0;
  VolumeHeader Header;
};

} // namespace

VolumeHeader readLegacyHeader(const fs::path& file)
{
  return LegacyText(file).read();
}

} // namespace ink::io
