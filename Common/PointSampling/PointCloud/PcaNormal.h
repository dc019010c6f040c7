// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>

namespace ink
{

/// The normal of a neighborhood: the direction of least variance by principal component analysis (Hoppe et
/// al. 1992, section 3.2) of the points with the indices `near`. Unit length, of either sign; (0, 0, 1) where
/// the points are collinear or coincide.
glm::vec3 pcaNormal(std::span<const glm::vec3> points, std::span<const std::uint32_t> near);

} // namespace ink
