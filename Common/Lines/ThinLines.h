#pragma once

#include "Lines/InkImage.h"

namespace ink
{

/// Leaves of lines and areas of ink their skeleton: lines one pixel wide that hang together by sides or
/// corners, near the middle of what was there, each pixel with the ink that it had.
///
/// Pixels of at least `threshold` (1 to 255) are ink, all others become empty. Layer by layer, and within a
/// layer from above, below, the left and the right in turn, those pixels go without which the ink still hangs
/// together as before, unless they end a line (Rosenfeld, A characterization of parallel thinning algorithms,
/// Information and Control 29, 1975). So no piece of ink vanishes, parts or joins another, and no hole opens
/// or closes. What is left has no pixel that could go, staircases included: doing it again changes nothing.
/// Pieces at the picture's border are thinned as if there were no ink beyond it.
///
/// The same on any number of threads.
/// \throws std::invalid_argument as InkImage::check
void thinLines(const InkImage& image, unsigned char threshold);

} // namespace ink
