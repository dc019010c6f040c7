#pragma once

#include "Fields/GridGeometry.h"
#include "Vdb/VdbError.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace ink
{

/// A box of voxels by their indices, both ends in it.
struct VoxelBox
{
  glm::ivec3 first = glm::ivec3(0);
  glm::ivec3 last = glm::ivec3(-1);

  bool empty() const;
  /// Samples along each axis.
  glm::dvec3 size() const;
  bool operator==(const VoxelBox&) const = default;
};

/// What a grid's values are meant to be.
enum class VdbClass
{
  Unknown,
  LevelSet,  ///< distances to a surface, negative inside
  FogVolume, ///< densities, 0 outside
  Staggered
};

/// What a .vdb file says about a grid before its voxels.
struct VdbGridInfo
{
  /// As in the file; the second of two grids "a" is "a[1]".
  std::string name;
  /// "float", "double", "half" (float or double stored with 16 bits), or what else was found, as "vec3s".
  std::string type;
  VdbClass gridClass = VdbClass::Unknown;
  /// Why the grid cannot be read; empty if it can, as far as is known before its voxels are read.
  std::string problem;

  /// Where voxel (i, j, k) lies: `direction * (spacing * (i, j, k)) + origin`.
  glm::dvec3 origin = glm::dvec3(0.0);
  glm::dvec3 spacing = glm::dvec3(1.0);
  glm::dmat3 direction = glm::dmat3(1.0);

  /// The active voxels: the smallest box around them and how many there are, where the file says it.
  std::optional<VoxelBox> activeBox;
  std::optional<std::int64_t> activeCount;
  /// The whole box of samples of the volume that the grid was made from, where vtkInk wrote it. Beyond it
  /// there is nothing, while a grid without it goes on with its background for ever.
  std::optional<VoxelBox> domain;
  /// The value of the surface that the grid is about: 0 for a level set, that of a narrow band by vtkInk.
  std::optional<double> surface;

  // Where and how the tree is stored.
  bool isDouble = false;
  bool isHalf = false;
  std::uint32_t compression = 0;
  std::uint64_t treeAt = 0;
};

/// The names of the metadata by which vtkInk keeps what a grid's transform alone does not say.
namespace vdbMetadata
{
constexpr const char* domainFirst = "ink_domain_first"; ///< vec3i
constexpr const char* domainLast = "ink_domain_last";   ///< vec3i
constexpr const char* spacing = "ink_spacing";          ///< vec3d
constexpr const char* direction = "ink_direction";      ///< mat4d, its first three rows and columns
constexpr const char* surface = "ink_surface";          ///< double
} // namespace vdbMetadata

/// The list of a .vdb file's grids. Written without OpenVDB, whose own functions believe every number in a
/// file; the voxels are not looked at but where the file does not say where its next grid is.
struct VdbFile
{
  /// Versions of the file format, which are those of OpenVDB 2 (2013) to 12.
  static constexpr std::uint32_t oldestVersion = 222;
  static constexpr std::uint32_t newestVersion = 224;

  std::uint32_t version = newestVersion;
  std::uint32_t libraryMajor = 0;
  std::uint32_t libraryMinor = 0;
  std::vector<VdbGridInfo> grids;

  /// \param in seekable and binary
  /// \throws VdbError
  static VdbFile list(std::istream& in);

  /// The grid of that name, or for an empty name the first that can be read.
  /// \throws VdbError if there is none, or it cannot be read
  const VdbGridInfo& find(const std::string& name) const;
};

} // namespace ink
