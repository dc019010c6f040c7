#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>

namespace ink
{

/// The direction in which some points are spread the least, by principal component analysis (Hoppe et al.
/// 1992, section 3.2). @param near indices into `points`. @return unit, of either sign; (0, 0, 1) where the
/// points lie on a line or at one place
glm::vec3 principalNormal(std::span<const glm::vec3> points, std::span<const std::uint32_t> near);

} // namespace ink
