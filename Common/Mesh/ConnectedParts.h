// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mesh/TriangleMesh.h"

#include <cstdint>
#include <vector>

namespace ink
{

/// The parts of a mesh, triangles that share points: of each point the number of its part, from 0 on, in the
/// order of their first points. A point of no triangle is a part of its own.
std::vector<std::uint32_t> connectedParts(const TriangleMesh& mesh);

} // namespace ink
