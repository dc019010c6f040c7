// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Raster/CoverageImage.h"

namespace ink::raster
{

/// The largest radius of dilate().
inline constexpr float mostLineGrowth = 128.0f;

/// Grayscale dilation with a disc: widens lines by `radius` pixels on each side, each pixel getting the
/// maximum of the ink within the radius. Ink up to a pixel farther is weighted by w(d) = radius + 1 - d in
/// [0, 1], so that edges stay antialiased and fractional radii work. A negative radius erodes: the paper is
/// dilated instead. Ink is monotonic in the radius; 0 changes nothing. Clamped to [-128, 128]; NaN counts as
/// 0. Pixels outside the image do not count.
///
/// The same for any number of threads, and a mirrored image gives the mirrored result.
/// @throws std::invalid_argument as CoverageImage::check
void dilate(const CoverageImage& image, float radius);

} // namespace ink::raster
