// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace ink
{

/// What points of borders are that coincide, see coincidentPoints.
enum class Seams : std::uint8_t
{
  Joined, ///< one point that the file lists several times: the surface goes on
  Apart   ///< points of the two sides of a feature edge, see splitAtFeatures: the surface ends
};

} // namespace ink
