// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "IsoSurface/ActiveCells.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace ink
{

/// An upper bound on the number of active cells, and so of samples, in each layer of cells along z; exact for
/// the half-open rule without missing samples. Costs a fraction of findActiveCells and stores nothing.
///
/// @param values dimensions.x * dimensions.y * dimensions.z samples, x fastest
/// @throws std::invalid_argument if the size of values is not the product of dimensions
/// @return one number per layer, none if there are fewer than two samples along an axis. The same for any
///   number of threads
template <class T>
std::vector<std::size_t> boundActiveCells(
  std::span<const T> values, const glm::ivec3& dimensions, double isoValue, CrossingRule rule);

} // namespace ink
