#pragma once

#include "Vdb/VdbGrid.h"

#include <openvdb/openvdb.h>

#include <glm/vec3.hpp>

#include <stdexcept>
#include <variant>

/// The side of Common/Vdb that knows OpenVDB: include it in sources only, as it takes long to compile.
namespace ink
{

struct VdbGrid::Tree
{
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

/// Looks values up, fast where one is near the last. Unlike OpenVDB's own accessors it costs nothing to make;
/// trees do not change.
template <class TreeType>
using VdbLookup = openvdb::tree::ValueAccessor<const TreeType, false>;

/// The edge of a leaf in voxels.
constexpr int leafSize = 8;
static_assert(openvdb::FloatTree::LeafNodeType::DIM == leafSize);

} // namespace ink
