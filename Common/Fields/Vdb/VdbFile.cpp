// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/Vdb/VdbFile.h"

#include "Fields/Vdb/VdbBytes.h"
#include "Fields/Vdb/VdbTreeCheck.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <utility>

namespace ink
{
namespace
{

/// A grid's transform: direction * spacing is `step`, bitwise if the file stores both.
struct Placement
{
  glm::dmat3 step = glm::dmat3(1.0);
  glm::dvec3 origin = glm::dvec3(0.0);
};

/// The metadata of a grid, as bytes.
using Metadata = std::map<std::string, std::pair<std::string, std::string>>;

class Lister
{
public:
  explicit Lister(std::istream& in)
    : Bytes(in)
  {
  }

  VdbFile run()
  {
    this->header();
    this->metadata(); // of the file
    const auto count = this->Bytes.get<std::int32_t>(Grids);
    if (count < 0)
    {
      throw VdbError("it says that it holds " + std::to_string(count) + " grids");
    }
    for (std::int32_t i = 0; i < count && !this->Lost; ++i)
    {
      this->grid();
    }
    this->followInstances();
    return std::move(this->File);
  }

private:
  static constexpr const char* Grids = "the list of grids";

  void header()
  {
    constexpr const char* what = "its header";
    constexpr std::int64_t magic = 0x56444220; // "VDB "
    if (this->Bytes.size() < sizeof magic || this->Bytes.get<std::int64_t>(what) != magic)
    {
      throw VdbError("it is not an OpenVDB file");
    }
    this->File.version = this->Bytes.get<std::uint32_t>(what);
    if (this->File.version < VdbFile::oldestVersion || this->File.version > VdbFile::newestVersion)
    {
      throw VdbError("its format has the version " + std::to_string(this->File.version) + "; expected " +
        std::to_string(VdbFile::oldestVersion) + " to " + std::to_string(VdbFile::newestVersion));
    }
    this->File.libraryMajor = this->Bytes.get<std::uint32_t>(what);
    this->File.libraryMinor = this->Bytes.get<std::uint32_t>(what);
    this->HasOffsets = this->Bytes.get<char>(what) != 0;
    constexpr int uuidLength = 36;
    this->Bytes.skip(uuidLength, what);
  }

  Metadata metadata()
  {
    constexpr const char* what = "its metadata";
    Metadata found;
    const auto count = this->Bytes.get<std::uint32_t>(what);
    for (std::uint32_t i = 0; i < count; ++i)
    {
      std::string name = this->Bytes.text(what);
      std::string type = this->Bytes.text(what);
      std::string value = this->Bytes.text(what);
      found.insert_or_assign(std::move(name), std::make_pair(std::move(type), std::move(value)));
    }
    return found;
  }

  void grid()
  {
    VdbGridInfo grid;
    grid.name = shownName(this->Bytes.text(Grids));
    readType(grid, this->Bytes.text(Grids));
    this->Parents.push_back(shownName(this->Bytes.text(Grids)));
    const auto start = this->Bytes.get<std::int64_t>(Grids);
    this->Bytes.get<std::int64_t>(Grids); // of the voxels, which follow the tree
    const auto end = this->Bytes.get<std::int64_t>(Grids);
    if (this->HasOffsets)
    {
      if (start < 0 || end < start)
      {
        throw VdbError(
          "it says that a grid lies from byte " + std::to_string(start) + " to " + std::to_string(end));
      }
      this->Bytes.seek(static_cast<std::uint64_t>(start), "a grid");
    }
    grid.compression = this->Bytes.get<std::uint32_t>("a grid");
    const Metadata metadata = this->metadata();
    const Placement placement = this->readTransform(grid);
    decompose(placement, metadata, grid);
    interpret(metadata, grid);
    grid.treeAt = this->Bytes.position();
    if (this->HasOffsets)
    {
      this->Bytes.seek(static_cast<std::uint64_t>(end), "the next grid");
    }
    else if (this->Parents.back().empty())
    {
      this->passTree(grid);
    }
    this->File.grids.push_back(std::move(grid));
  }

  /// In a file written to a pipe, the position of the next grid is only known at the end of a grid.
  void passTree(const VdbGridInfo& grid)
  {
    if (!Stored(grid.type))
    {
      this->Lost = true;
      return;
    }
    checkVdbTree(this->Bytes, { grid.isDouble ? 8 : 4, grid.isHalf, grid.compression });
  }

  static bool Stored(const std::string& type)
  {
    return type == "float" || type == "double" || type == "half";
  }

  /// OpenVDB distinguishes grids of the same name by a number after a separator.
  static std::string shownName(const std::string& unique)
  {
    constexpr char separator = '\x1e';
    const std::size_t at = unique.find(separator);
    return at == std::string::npos ? unique : unique.substr(0, at) + "[" + unique.substr(at + 1) + "]";
  }

  static void readType(VdbGridInfo& grid, std::string type)
  {
    const std::string halfSuffix = "_HalfFloat";
    const std::string prefix = "Tree_";
    const std::string shape = "_5_4_3";
    if (type.ends_with(halfSuffix))
    {
      grid.isHalf = true;
      type.resize(type.size() - halfSuffix.size());
    }
    grid.type = type;
    if (type.starts_with(prefix) && type.ends_with(shape) && type.size() > prefix.size() + shape.size())
    {
      grid.type = type.substr(prefix.size(), type.size() - prefix.size() - shape.size());
    }
    grid.isDouble = grid.type == "double";
    if (grid.type != "float" && grid.type != "double")
    {
      grid.problem = "its values have the type '" + grid.type + "'; expected float, double or half";
    }
    else if (grid.isHalf)
    {
      grid.type = "half";
    }
  }

  glm::dvec3 vector()
  {
    glm::dvec3 v;
    this->Bytes.read(&v, sizeof v, "a grid's transform");
    return v;
  }

  Placement readTransform(VdbGridInfo& grid)
  {
    constexpr const char* what = "a grid's transform";
    Placement placement;
    const std::string map = this->Bytes.text(what);
    const auto scale = [&](const glm::dvec3& s)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        placement.step[axis][axis] = s[axis];
      }
      // Its absolute and its inverse values are stored as well.
      constexpr int derived = 4;
      this->Bytes.skip(derived * sizeof(glm::dvec3), what);
    };
    if (map == "ScaleMap" || map == "UniformScaleMap")
    {
      scale(this->vector());
    }
    else if (map == "ScaleTranslateMap" || map == "UniformScaleTranslateMap")
    {
      placement.origin = this->vector();
      scale(this->vector());
    }
    else if (map == "TranslationMap")
    {
      placement.origin = this->vector();
    }
    else if (map == "AffineMap" || map == "UnitaryMap")
    {
      // World = index * matrix, with the indices as a row.
      double matrix[4][4];
      this->Bytes.read(matrix, sizeof matrix, what);
      for (int axis = 0; axis < 3; ++axis)
      {
        placement.step[axis] = { matrix[axis][0], matrix[axis][1], matrix[axis][2] };
        placement.origin[axis] = matrix[3][axis];
      }
    }
    else
    {
      grid.problem = grid.problem.empty()
        ? "its transform is a '" + map + "'; expected a linear one (scale, rotation, shear, translation)"
        : grid.problem;
      // Of a map of unknown size the end is not known.
      this->Lost = !this->HasOffsets;
    }
    return placement;
  }

  static void decompose(const Placement& placement, const Metadata& metadata, VdbGridInfo& grid)
  {
    grid.origin = placement.origin;
    for (int axis = 0; axis < 3; ++axis)
    {
      grid.spacing[axis] = glm::length(placement.step[axis]);
      grid.direction[axis] = placement.step[axis] / grid.spacing[axis];
    }
    // The stored factors, if they still match: a product cannot be factored without rounding.
    glm::dvec3 spacing;
    double stored[4][4];
    if (value(metadata, vdbMetadata::spacing, "vec3d", spacing) &&
      value(metadata, vdbMetadata::direction, "mat4d", stored))
    {
      glm::dmat3 direction;
      bool same = true;
      for (int axis = 0; axis < 3; ++axis)
      {
        direction[axis] = { stored[axis][0], stored[axis][1], stored[axis][2] };
        const double tolerance = 1e-12 * glm::length(placement.step[axis]);
        same = same && glm::distance(direction[axis] * spacing[axis], placement.step[axis]) <= tolerance;
      }
      if (same)
      {
        grid.spacing = spacing;
        grid.direction = direction;
      }
    }
    if (grid.problem.empty())
    {
      try
      {
        GridGeometry(glm::ivec3(0), grid.origin, grid.spacing, grid.direction);
      }
      catch (const std::invalid_argument& error)
      {
        grid.problem = error.what();
      }
    }
  }

  template <class T>
  static bool value(const Metadata& metadata, const char* name, const char* type, T& to)
  {
    const auto found = metadata.find(name);
    if (found == metadata.end() || found->second.first != type || found->second.second.size() != sizeof to)
    {
      return false;
    }
    std::memcpy(&to, found->second.second.data(), sizeof to);
    return true;
  }

  static std::optional<VoxelBox> box(const Metadata& metadata, const char* first, const char* last)
  {
    VoxelBox box;
    const bool whole = value(metadata, first, "vec3i", box.first) && value(metadata, last, "vec3i", box.last);
    return whole ? std::optional(box) : std::nullopt;
  }

  static void interpret(const Metadata& metadata, VdbGridInfo& grid)
  {
    grid.activeBox = box(metadata, "file_bbox_min", "file_bbox_max");
    grid.domain = box(metadata, vdbMetadata::domainFirst, vdbMetadata::domainLast);
    if (grid.domain && grid.domain->empty())
    {
      grid.domain.reset();
    }
    std::int64_t count = 0;
    if (value(metadata, "file_voxel_count", "int64", count))
    {
      grid.activeCount = count;
    }
    const auto text = metadata.find("class");
    const std::string name = text == metadata.end() ? "" : text->second.second;
    grid.gridClass = name == "level set" ? VdbClass::LevelSet
      : name == "fog volume"             ? VdbClass::FogVolume
      : name == "staggered"              ? VdbClass::Staggered
                                         : VdbClass::Unknown;
    double surface = 0.0;
    if (grid.gridClass == VdbClass::LevelSet || value(metadata, vdbMetadata::surface, "double", surface))
    {
      grid.surface = surface;
    }
  }

  /// Grids may share a tree, which is then stored with one of them.
  void followInstances()
  {
    for (std::size_t i = 0; i < this->File.grids.size(); ++i)
    {
      VdbGridInfo& grid = this->File.grids[i];
      const std::string& parent = this->Parents[i];
      if (parent.empty() || !grid.problem.empty())
      {
        continue;
      }
      const auto found = std::find_if(this->File.grids.begin(), this->File.grids.end(),
        [&](const VdbGridInfo& other) { return other.name == parent; });
      const auto index = found - this->File.grids.begin();
      if (found == this->File.grids.end() || !this->Parents[static_cast<std::size_t>(index)].empty() ||
        found->type != grid.type || found->isDouble != grid.isDouble)
      {
        grid.problem = "it shares the tree of a grid '" + parent + "', which the file does not hold";
        continue;
      }
      grid.treeAt = found->treeAt;
      grid.compression = found->compression;
    }
  }

  VdbBytes Bytes;
  VdbFile File;
  bool HasOffsets = true;
  bool Lost = false; ///< where the next grid is
  std::vector<std::string> Parents;
};

std::string quoted(const std::vector<VdbGridInfo>& grids)
{
  std::string list;
  for (const VdbGridInfo& grid : grids)
  {
    list += (list.empty() ? "'" : ", '") + grid.name + "' (" + grid.type + ")";
  }
  return list.empty() ? "none" : list;
}

} // namespace

bool VoxelBox::empty() const
{
  return this->last.x < this->first.x || this->last.y < this->first.y || this->last.z < this->first.z;
}

glm::dvec3 VoxelBox::size() const
{
  return this->empty() ? glm::dvec3(0.0) : glm::dvec3(this->last) - glm::dvec3(this->first) + 1.0;
}

VdbFile VdbFile::list(std::istream& in)
{
  return Lister(in).run();
}

const VdbGridInfo& VdbFile::find(const std::string& name) const
{
  const auto fits = [&](const VdbGridInfo& grid)
  { return name.empty() ? grid.problem.empty() : grid.name == name; };
  const auto found = std::find_if(this->grids.begin(), this->grids.end(), fits);
  if (found == this->grids.end())
  {
    if (name.empty() && this->grids.size() == 1)
    {
      throw VdbError("grid '" + this->grids[0].name + "': " + this->grids[0].problem);
    }
    throw VdbError(
      (name.empty() ? "it holds no grid of floating-point numbers" : "it holds no grid '" + name + "'") +
      "; its grids: " + quoted(this->grids));
  }
  if (!found->problem.empty())
  {
    throw VdbError("grid '" + found->name + "': " + found->problem);
  }
  return *found;
}

} // namespace ink
