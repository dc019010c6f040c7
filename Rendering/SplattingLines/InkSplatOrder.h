// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSplatOrder_h
#define InkSplatOrder_h

#include <cstdint>
#include <vector>

class vtkDataArray;

/// The indices of points so that any first part of them is spread over all.
/// @param priorities one a point, smaller ones first; null: an order by chance, the same each time
std::vector<std::uint32_t> InkFindSplatOrder(std::uint32_t count, vtkDataArray* priorities);

#endif
