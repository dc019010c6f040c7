// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Vdb/VdbGrid.h"

#include <openvdb/openvdb.h>

#include <glm/vec3.hpp>

#include <stdexcept>
#include <variant>

/// The part of Common/Fields/Vdb that includes OpenVDB: only for sources, as it takes long to compile.
namespace ink
{

/// Made and freed in VdbGrid.cpp alone: a source that does so compiles all virtual functions of both trees.
struct VdbGrid::Tree
{
  /// Of double or else float; holds nothing but the background.
  explicit Tree(bool isDouble, double background = 0.0);
  ~Tree();

  std::variant<openvdb::FloatTree, openvdb::DoubleTree> values;
};

inline openvdb::Coord toCoord(const glm::ivec3& v)
{
  return openvdb::Coord(v.x, v.y, v.z);
}

inline glm::ivec3 toVector(const openvdb::Coord& c)
{
  return glm::ivec3(c.x(), c.y(), c.z());
}

inline openvdb::CoordBBox toBBox(const VoxelBox& box)
{
  return openvdb::CoordBBox(toCoord(box.first), toCoord(box.last));
}

inline VoxelBox toBox(const openvdb::CoordBBox& box)
{
  return box.empty() ? VoxelBox() : VoxelBox{ toVector(box.min()), toVector(box.max()) };
}

/// A cached lookup of values, fast for spatially coherent queries. Unlike OpenVDB's default accessors it is
/// not registered with the tree, which is immutable, and so costs nothing to construct.
template <class TreeType>
using VdbLookup = openvdb::tree::ValueAccessor<const TreeType, false>;

/// The edge of a leaf in voxels.
constexpr int leafSize = 8;
static_assert(openvdb::FloatTree::LeafNodeType::DIM == leafSize);

} // namespace ink
