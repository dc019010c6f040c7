// SPDX-License-Identifier: BSD-3-Clause
#include "OpenVDBTrees.h"

template class openvdb::tree::Tree<openvdb::FloatTree::RootNodeType>;
template class openvdb::tree::Tree<openvdb::DoubleTree::RootNodeType>;
template class openvdb::Grid<openvdb::FloatTree>;
template class openvdb::Grid<openvdb::DoubleTree>;
