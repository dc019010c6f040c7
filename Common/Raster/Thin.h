// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Raster/CoverageImage.h"

namespace ink::raster
{

/// Reduces lines and areas of ink to their skeleton: 8-connected lines one pixel wide, near the medial axis,
/// each pixel with its original ink.
///
/// Pixels of at least `threshold` (1 to 255) are ink, all others become empty. Layer by layer, and within a
/// layer from the top, bottom, left and right in turn, simple pixels, whose removal preserves the topology,
/// are removed unless they end a line (Rosenfeld, A characterization of parallel thinning algorithms,
/// Information and Control 29, 1975). So no component vanishes, splits or merges, and no hole opens or
/// closes. The result has no removable pixels left, staircases included: thinning is idempotent. Components
/// at the image's border are thinned as if there were no ink beyond it.
///
/// The same for any number of threads.
/// @throws std::invalid_argument as CoverageImage::check
void thin(const CoverageImage& image, unsigned char threshold);

} // namespace ink::raster
