// SPDX-License-Identifier: BSD-3-Clause
#include "IsoSurface/StencilShape.h"

#include "IsoSurface/RobustPlacement.h"

namespace ink
{
namespace
{

glm::ivec3 offsetOf(int n, NormalMethod method)
{
  if (method == NormalMethod::Regression)
  {
    return { (n & 3) - 1, (n >> 2 & 3) - 1, (n >> 4) - 1 };
  }
  if (n >= StencilSize)
  {
    return glm::ivec3(0);
  }
  if (n < Corners)
  {
    return { n & 1, n >> 1 & 1, n >> 2 };
  }
  const int axis = (n - Corners) % Edges / 4;
  const int corner = lowCorner(axis, n % 4);
  glm::ivec3 offset(corner & 1, corner >> 1 & 1, corner >> 2);
  offset[axis] += n < Corners + Edges ? -1 : 2;
  return offset;
}

} // namespace

StencilShape::StencilShape(NormalMethod method)
  : size(method == NormalMethod::Cell        ? Corners
        : method == NormalMethod::Regression ? WideStencilSize
                                             : StencilSize)
{
  for (int n = 0; n < WideStencilSize; ++n)
  {
    this->offsets[n] = offsetOf(n, method);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (method == NormalMethod::Regression)
    {
      constexpr int steps[3] = { 1, 4, 16 };
      const int step = steps[axis];
      for (int n = 0; n < 16; ++n)
      {
        const int outer = axis == 0 ? 4 * n : axis == 1 ? n % 4 + 16 * (n / 4) : n;
        this->continuations[axis][0].push_back({ outer, outer + step, outer + 2 * step });
        this->continuations[axis][1].push_back({ outer + 3 * step, outer + 2 * step, outer + step });
      }
      continue;
    }
    for (int n = 0; n < 4; ++n)
    {
      const int low = lowCorner(axis, n);
      const int high = highCorner(axis, n);
      this->continuations[axis][0].push_back({ neighborBefore(axis, n), low, high });
      this->continuations[axis][1].push_back({ neighborAfter(axis, n), high, low });
    }
  }
}

} // namespace ink
