// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>

namespace ink::stipple
{

/// The box that positions are quantized in: it starts at `low` and has edges of `scale` times the lengths
/// common to all boxes. So boxes differ in size but not in proportion, and positions in anisotropic voxels
/// have the same relative precision along all axes.
struct QuantizationBox
{
  glm::vec3 low{ 0.0f };
  float scale = 0.0f;
};

/// The number of quantization steps along an axis: coordinates are integers from 0 to this.
constexpr int quantizationSteps = 1023;

/// The smallest box from `low` that contains `high`.
/// @param edges the box's edges at scale 1, not negative; along an axis where this is 0, low and high must be
///   equal
QuantizationBox fitQuantizationBox(const glm::vec3& low, const glm::vec3& high, const glm::vec3& edges);

/// Quantizes a position to ten bits per axis, x in the lowest. The error along an axis is at most half a
/// step, scale * edge / (2 * quantizationSteps). Positions outside the box are clamped to it.
std::uint32_t quantizePosition(const glm::vec3& position, const QuantizationBox& box, const glm::vec3& edges);

/// The quantized position; the same formula as in vtkInkStippleMapper's vertex shader.
glm::vec3 dequantizePosition(std::uint32_t packed, const QuantizationBox& box, const glm::vec3& edges);

} // namespace ink::stipple
