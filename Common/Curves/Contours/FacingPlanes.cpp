// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/FacingPlanes.h"

#include <algorithm>
#include <cstring>

#if defined(__x86_64__)
#  include <immintrin.h>
#elif defined(__aarch64__)
#  include <arm_neon.h>
#endif

namespace ink
{

namespace
{

#include "Simd/Simd.h"

using Floats = Group<float>;

/// n.v of as many planes as a group has elements.
Floats facingOf(const glm::vec4* planes, const std::uint32_t* ids, const glm::vec4& eye)
{
  // Plane k of each quarter of 16 bytes: the products, which are summed across.
  Floats products[4];
  for (int k = 0; k < 4; ++k)
  {
    Floats plane;
    Floats position;
    for (int quarter = 0; quarter < GroupSize / 4; ++quarter)
    {
      std::memcpy(reinterpret_cast<char*>(&plane) + 16 * quarter, planes + ids[4 * quarter + k], 16);
      std::memcpy(reinterpret_cast<char*>(&position) + 16 * quarter, &eye, 16);
    }
    products[k] = plane * position;
  }
  const auto pairs = [](const Floats& a, const Floats& b)
  { return shuffleQuads<0, 1, 0, 1>(a, b) + shuffleQuads<2, 3, 2, 3>(a, b); };
  const Floats low = pairs(products[0], products[1]);
  const Floats high = pairs(products[2], products[3]);
  return shuffleQuads<0, 2, 0, 2>(low, high) + shuffleQuads<1, 3, 1, 3>(low, high);
}

} // namespace

FacingPlanes::View::View(const FacingPlanes& planes, const Eye& eye)
  : Planes(planes.Planes.data())
  , Position(planes.Ball.toBall(eye), eye.parallel ? 0.0f : -1.0f)
  , Slack(facingSlack(glm::vec3(this->Position)))
{
}

FacingPlanes::Sides FacingPlanes::View::sides(const std::uint32_t* planes) const
{
  Sides sides{ 0, 0 };
  for (std::size_t i = 0; i < atOnce; i += GroupSize)
  {
    // An eye beyond float makes NaN, for which neither holds.
    const Floats facing = facingOf(this->Planes, planes + i, this->Position);
    sides.front |= static_cast<std::uint32_t>(bitsOf<4>(facing > this->Slack)) << i;
    sides.back |= static_cast<std::uint32_t>(bitsOf<4>(facing < -this->Slack)) << i;
  }
  return sides;
}

} // namespace ink
