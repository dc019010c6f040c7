// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mesh/TriangleMesh.h"

namespace ink
{

/// The length of a mesh's longest border, with all borders that it joins. 0 if it is closed.
/// @param mesh in which points that coincide are one, as WeldedTriangles makes it
double longestBorder(const TriangleMesh& mesh);

} // namespace ink
