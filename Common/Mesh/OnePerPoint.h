// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mesh/TriangleMesh.h"

#include <cstddef>
#include <stdexcept>
#include <string>

namespace ink
{

/// @param what the values are, in plural
/// @throws std::invalid_argument unless there are as many values as a mesh has points
inline void checkOnePerPoint(const TriangleMesh& mesh, std::size_t count, const char* what)
{
  if (count != mesh.points.size())
  {
    throw std::invalid_argument("there are " + std::to_string(count) + " " + what + " for " +
      std::to_string(mesh.points.size()) + " points, expected one per point");
  }
}

} // namespace ink
