// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Grid/GridGeometry.h"
#include "Fields/Vdb/VdbError.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace ink
{

/// A box of voxel indices, both ends inclusive.
struct VoxelBox
{
  glm::ivec3 first = glm::ivec3(0);
  glm::ivec3 last = glm::ivec3(-1);

  bool empty() const;
  /// Samples along each axis.
  glm::dvec3 size() const;
  bool operator==(const VoxelBox&) const = default;
};

/// The class of a grid: the meaning of its values.
enum class VdbClass
{
  Unknown,
  LevelSet,  ///< distances to a surface, negative inside
  FogVolume, ///< densities, 0 outside
  Staggered
};

/// The header of a grid in a .vdb file.
struct VdbGridInfo
{
  /// As in the file; the second of two grids "a" is "a[1]".
  std::string name;
  /// "float", "double", "half" (float or double stored with 16 bits), or an unsupported type such as "vec3s".
  std::string type;
  VdbClass gridClass = VdbClass::Unknown;
  /// Why the grid cannot be read; empty if it can, as far as is known before its voxels are read.
  std::string problem;

  /// The position of voxel (i, j, k) is `direction * (spacing * (i, j, k)) + origin`.
  glm::dvec3 origin = glm::dvec3(0.0);
  glm::dvec3 spacing = glm::dvec3(1.0);
  glm::dmat3 direction = glm::dmat3(1.0);

  /// The bounding box and number of active voxels, if the file has them.
  std::optional<VoxelBox> activeBox;
  std::optional<std::int64_t> activeCount;
  /// The extent of the volume that the grid was made from, if vtkInk wrote it. Outside of it the grid is
  /// undefined, while a grid without a domain continues with its background indefinitely.
  std::optional<VoxelBox> domain;
  /// The iso-value that the grid represents: 0 for a level set, that of the narrow band for grids written by
  /// vtkInk.
  std::optional<double> surface;

  // Location and encoding of the tree.
  bool isDouble = false;
  bool isHalf = false;
  std::uint32_t compression = 0;
  std::uint64_t treeAt = 0;
};

/// The metadata keys under which vtkInk stores what a grid's transform does not preserve.
namespace vdbMetadata
{
constexpr const char* domainFirst = "ink_domain_first"; ///< vec3i
constexpr const char* domainLast = "ink_domain_last";   ///< vec3i
constexpr const char* spacing = "ink_spacing";          ///< vec3d
constexpr const char* direction = "ink_direction";      ///< mat4d, its first three rows and columns
constexpr const char* surface = "ink_surface";          ///< double
} // namespace vdbMetadata

/// The list of a .vdb file's grids. Parsed without OpenVDB, whose own functions trust every number in a file;
/// voxels are only read where the file does not give the position of its next grid.
struct VdbFile
{
  /// Supported versions of the file format: those of OpenVDB 2 (2013) to 12.
  static constexpr std::uint32_t oldestVersion = 222;
  static constexpr std::uint32_t newestVersion = 224;

  std::uint32_t version = newestVersion;
  std::uint32_t libraryMajor = 0;
  std::uint32_t libraryMinor = 0;
  std::vector<VdbGridInfo> grids;

  /// @param in seekable and binary
  /// @throws VdbError
  static VdbFile list(std::istream& in);

  /// The grid of that name, or for an empty name the first that can be read.
  /// @throws VdbError if there is none, or it cannot be read
  const VdbGridInfo& find(const std::string& name) const;
};

} // namespace ink
