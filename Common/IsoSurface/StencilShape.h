// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Simd/SamplingKernels.h"

#include <glm/vec3.hpp>

#include <vector>

/// Internal to Common/IsoSurface.
namespace ink
{

/// The offsets of a batch's rows from a cell, for a method to estimate normals.
struct StencilShape
{
  /// A row outside the grid, and the two that it is extrapolated from.
  struct Continuation
  {
    int outer;
    int near;
    int far;
  };

  explicit StencilShape(NormalMethod method);

  int size; ///< rows in use
  glm::ivec3 offsets[WideStencilSize];
  /// For rows before the first cell along an axis, and after the last.
  std::vector<Continuation> continuations[3][2];
};

} // namespace ink
