// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Raster/CoverageImage.h"

namespace ink::raster
{

/// Borders at which an image continues, as a tile of a larger one does.
struct CutBorders
{
  bool left = false;
  bool right = false;
  bool bottom = false; ///< below the first row
  bool top = false;
};

/// Erases speckles too short for a line: components of ink whose extent is less than `shortest` pixels. A
/// component is a set of 8-connected pixels of at least `threshold` (1 to 255); its extent is one more than
/// the diagonal of the bounding box of its pixel centers, so that one pixel has 1 and a straight row of n has
/// n. Components at a cut border stay, as their extent is unknown.
///
/// Ink fainter than the threshold, like the antialiased edge of a line, stays if any component that it
/// touches stays; if it touches none, it is a component itself.
///
/// The same for any number of threads, and a mirrored image gives the mirrored result.
/// @throws std::invalid_argument as CoverageImage::check
void despeckle(
  const CoverageImage& image, float shortest, unsigned char threshold, const CutBorders& cut = {});

} // namespace ink::raster
