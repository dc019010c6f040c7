#pragma once

#include "Sampling/CrossedCells.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace ink
{

/// How many points an iso-surface will have: for each layer of cells along z a number of cells that is never
/// smaller than that of the cells crossed. It is the same by the half-open rule where no corner is missing.
/// Costs a fraction of what findCrossedCells does and keeps nothing.
///
/// \param values     dimensions.x * dimensions.y * dimensions.z samples, x fastest
/// \throws std::invalid_argument if the size of values is not the product of dimensions
/// \returns one number for each layer, none if there are fewer than two samples along an axis. The same for
/// any
///          number of threads
template <class T>
std::vector<std::size_t> boundCrossedCells(
  std::span<const T> values, const glm::ivec3& dimensions, double isoValue, CrossingRule rule);

} // namespace ink
