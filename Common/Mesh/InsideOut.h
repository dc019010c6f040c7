// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mesh/TriangleMesh.h"

namespace ink
{

/// Whether a closed mesh is wound inside out: its triangles run clockwise seen from outside, so that the
/// volume within is negative. Open meshes have no inside and are never so; those with holes count as closed
/// if the area vectors of their triangles, which add up to zero on closed ones, leave less than a tenth of
/// the area. Triangles with a point that is not finite do not count.
bool isInsideOut(const TriangleMesh& mesh);

} // namespace ink
