#pragma once

#include "Sampling/Kernels/SamplingKernels.h"

#include <glm/vec3.hpp>

#include <vector>

/// Internal to Common/Sampling.
namespace ink
{

/// Where the rows of a batch stand around a cell, for a way to find normals.
struct StencilShape
{
  /// A row beyond the grid's border, and the two that it continues.
  struct Continuation
  {
    int outer;
    int near;
    int far;
  };

  explicit StencilShape(NormalMethod method);

  int size; ///< rows that are in use
  glm::ivec3 places[WideStencilSize];
  /// Those before the first cell along an axis, and after the last.
  std::vector<Continuation> continuations[3][2];
};

} // namespace ink
