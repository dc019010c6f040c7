// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <openvdb/openvdb.h>

#include <string>

/// The grids that most tests write. OpenVDB leaves each source that makes one to compile all virtual
/// functions of its tree, which takes longer than the tests themselves.
extern template class openvdb::tree::Tree<openvdb::FloatTree::RootNodeType>;
extern template class openvdb::tree::Tree<openvdb::DoubleTree::RootNodeType>;
extern template class openvdb::Grid<openvdb::FloatTree>;
extern template class openvdb::Grid<openvdb::DoubleTree>;

namespace ink::testing
{

/// An empty grid of another type, which OpenVDB's library makes, so that none of it is compiled here.
template <class Grid>
openvdb::GridBase::Ptr emptyGrid(const std::string& name)
{
  openvdb::initialize();
  const openvdb::GridBase::Ptr grid = openvdb::GridBase::createGrid(Grid::gridType());
  grid->setName(name);
  return grid;
}

} // namespace ink::testing
