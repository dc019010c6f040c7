// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeHeader.h"

#include "Core/FormatNumber.h"
#include "InkActiveScalars.h"
#include "LegacyFile.h"
#include "ReadError.h"
#include "Words.h"

#include "vtkType.h"

#include <algorithm>
#include <cstdint>
#include <ios>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

/// The values of points, or of cells, that are used.
struct Chosen
{
  std::optional<LegacyArray> array;
  double tuples = 0; ///< how many points, or cells, there are

  bool areScalars() const { return this->array && this->array->areScalars; }
};

/// Reads structured points up to the values that are used: the first SCALARS of points, else the first
/// others; where points have none, those of cells, as voxels in the cells' centers. Of a rectilinear or
/// structured grid the others as InkRankOfArray has them, as of one in XML, and the marks of what is hidden.
class LegacyVolume
{
public:
  explicit LegacyVolume(const fs::path& file)
    : File(file)
    , Legacy(file)
  {
  }

  VolumeHeader read()
  {
    this->useKind();
    std::string word;
    while (!this->hasAll() && this->Legacy.tryWord(word))
    {
      if (!this->takeShape(word) && !this->takeCoordinates(word) &&
        !this->Legacy.passValues(word, this->In ? this->In->tuples : 0.0,
          [this](const LegacyArray& array) { return this->take(array); }))
      {
        this->Legacy.fail(word, "a keyword as DIMENSIONS, POINT_DATA or SCALARS");
      }
    }
    const Chosen& chosen = this->OfPoints.array ? this->OfPoints : this->OfCells;
    if (!chosen.array)
    {
      failToRead(this->File, lackOfValues);
    }
    this->use(chosen);
    this->Header.voxels.check(this->File);
    this->checkCoordinates();
    return this->Header;
  }

private:
  void useKind()
  {
    static const std::map<std::string, const char*> kinds{ { "structured_points", "structured points" },
      { "rectilinear_grid", "a rectilinear grid" }, { "structured_grid", "a structured grid" } };
    const auto kind = kinds.find(this->Legacy.kind());
    if (kind == kinds.end())
    {
      failToRead(this->File,
        "it is not a legacy VTK file of a volume: it says '" + shortened(this->Legacy.kind()) +
          "'; expected DATASET STRUCTURED_POINTS, RECTILINEAR_GRID or STRUCTURED_GRID");
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
        dimension = static_cast<int>(this->Legacy.whole(1, "a number of voxels of 1 or more"));
      }
      this->Header.voxels.type = VTK_UNSIGNED_CHAR;
      this->Header.voxels.checkDimensions(this->File);
    }
    else if (keyword == "spacing" || keyword == "aspect_ratio")
    {
      for (double& spacing : this->Header.spacing)
      {
        spacing = spacingOf(this->Legacy.number("a distance between voxels"));
      }
    }
    else if (keyword == "origin")
    {
      for (double& origin : this->Header.origin)
      {
        origin = this->Legacy.number("the position of the first voxel");
      }
    }
    else if (keyword == "cell_data" || keyword == "point_data")
    {
      this->In = keyword == "point_data" ? &this->OfPoints : &this->OfCells;
      this->In->tuples = this->Legacy.whole(0, "a number of values");
      const auto voxels =
        static_cast<double>(this->Header.voxels.sliceValues()) * this->Header.voxels.dimensions[2];
      if (this->In == &this->OfPoints && this->In->tuples != voxels)
      {
        this->Legacy.fail(std::to_string(static_cast<std::int64_t>(this->In->tuples)),
          "the number of all voxels, " + std::to_string(static_cast<std::int64_t>(voxels)) + ",");
      }
      this->Legacy.beginValues();
    }
    else if (keyword == "metadata")
    {
      this->Legacy.skipMetadata();
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
    if (kind == kinds.end() || kind->second != this->Legacy.kind())
    {
      return false;
    }
    const int* dimensions = this->Header.voxels.dimensions;
    const bool arePoints = keyword == "points";
    std::vector<RawVolume>& all = this->Header.coordinates;
    const double expected = arePoints ? static_cast<double>(this->Header.voxels.sliceValues()) * dimensions[2]
                                      : dimensions[keyword.front() - 'x'];
    const double found = this->Legacy.whole(0, "a number of coordinates");
    const std::string typeName = this->Legacy.word("a type");
    this->Legacy.beginValues();
    const int type = LegacyFile::typeOf(typeName);
    const std::size_t place = arePoints ? 0 : static_cast<std::size_t>(keyword.front() - 'x');
    if (found != expected || place != all.size() || type == VTK_VOID || type == VTK_BIT)
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
    this->place(coordinates, type, this->Legacy.position());
    all.push_back(coordinates);
    this->Legacy.skip(found * (arePoints ? perPoint : 1), type);
    return true;
  }

  void checkCoordinates() const
  {
    const std::size_t expected = !this->isGrid() ? 0 : (this->Legacy.kind() == "rectilinear_grid" ? 3 : 1);
    if (this->Header.coordinates.size() != expected)
    {
      failToRead(this->File,
        "it does not say where its points are: expected " +
          std::string(expected == 1 ? "POINTS" : "X_COORDINATES, Y_COORDINATES and Z_COORDINATES"));
    }
    for (const std::vector<RawVolume>* all : { &this->Header.coordinates, &this->Header.marks })
    {
      for (const RawVolume& numbers : *all)
      {
        numbers.check(this->File);
      }
    }
  }

  void place(RawVolume& values, int type, std::streamoff begin) const
  {
    values.type = type;
    values.files = { this->File };
    values.offset = static_cast<std::uint64_t>(std::max<std::streamoff>(begin, 0));
    values.encoding = this->Legacy.isText() ? VoxelEncoding::Text : VoxelEncoding::Plain;
    if (!this->Legacy.isText())
    {
      values.setBigEndian(true);
    }
  }

  bool isGrid() const { return this->Legacy.kind() != "structured_points"; }

  /// Whether no more is looked for: of a grid, marks may come last.
  bool hasAll() const { return !this->isGrid() && this->OfPoints.areScalars(); }

  /// @return false where no more is looked for
  bool take(const LegacyArray& array)
  {
    if (!this->In || array.tuples != this->In->tuples || array.components < 1)
    {
      return true;
    }
    if (InkIsGhostArray(array.name.c_str()))
    {
      if (this->isGrid() && array.type == VTK_UNSIGNED_CHAR && array.components == 1)
      {
        RawVolume& marks = this->Header.marks.emplace_back();
        marks.dimensions[0] = static_cast<int>(array.tuples);
        marks.dimensions[1] = marks.dimensions[2] = 1;
        this->place(marks, array.type, array.begin);
      }
      return true;
    }
    const auto rankOf = [this](const LegacyArray& one)
    {
      return this->isGrid() ? InkRankOfArray(static_cast<int>(one.components), one.name.c_str())
                            : std::pair<bool, std::string>();
    };
    std::optional<LegacyArray>& found = this->In->array;
    if (!found || array.areScalars > found->areScalars ||
      (array.areScalars == found->areScalars && !array.areScalars && rankOf(array) < rankOf(*found)))
    {
      found = array;
    }
    return !this->hasAll();
  }

  void use(const Chosen& chosen)
  {
    if (chosen.array->type == VTK_BIT)
    {
      failToRead(
        this->File, "its voxels are single bits; expected integers of 8 to 64 bits, float or double");
    }
    RawVolume& voxels = this->Header.voxels;
    if (&chosen == &this->OfCells)
    {
      this->moveToCells();
    }
    this->place(voxels, chosen.array->type, chosen.array->begin);
    voxels.components = static_cast<int>(chosen.array->components);
    this->Header.components = voxels.components;
    if (!chosen.areScalars())
    {
      this->Header.notes.push_back("array '" + chosen.array->name + "' is used");
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
      this->Legacy.fail(std::to_string(static_cast<std::int64_t>(this->OfCells.tuples)),
        "the number of all cells, " + std::to_string(static_cast<std::int64_t>(cells)) + ",");
    }
    this->Header.notes.emplace_back(noteOfCells);
  }

  const fs::path& File;
  LegacyFile Legacy;
  Chosen OfPoints;
  Chosen OfCells;
  Chosen* In = nullptr; ///< whose values come next; null: nobody's
  VolumeHeader Header;
};

} // namespace

VolumeHeader readLegacyHeader(const fs::path& file)
{
  return LegacyVolume(file).read();
}

} // namespace ink::io
