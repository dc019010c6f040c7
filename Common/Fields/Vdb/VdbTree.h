// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Vdb/VdbGrid.h"

#include <openvdb/openvdb.h>

#include <glm/vec3.hpp>

#include <utility>
#include <variant>

/// The part of Common/Fields/Vdb that includes OpenVDB: only for sources, as it takes long to compile.
namespace ink
{

/// A tree that holds nothing but a background of 0, from OpenVDB's registry: OpenVDB's library has all
/// virtual functions of its trees, and a source that constructs one would compile them again.
template <class TreeType>
typename TreeType::Ptr makeVdbTree()
{
  openvdb::initialize();
  return openvdb::StaticPtrCast<TreeType>(openvdb::GridBase::createGrid(TreeType::treeType())->baseTreePtr());
}

/// Of double or else float, known by type to those that visit it.
struct VdbGrid::Tree
{
  explicit Tree(bool isDouble);

  /// body(const TreeType&)
  template <class Body>
  auto visit(const Body& body) const
  {
    return std::visit([&](const auto& tree) { return body(std::as_const(*tree)); }, this->values);
  }

  std::variant<openvdb::FloatTree::Ptr, openvdb::DoubleTree::Ptr> values;
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
