#pragma once

#include "Lines/InkImage.h"

namespace ink
{

/// Borders beyond which a picture goes on, as a tile of a larger one does.
struct CutBorders
{
  bool left = false;
  bool right = false;
  bool bottom = false; ///< below the first row
  bool top = false;
};

/// Erases what is too short for a line: spots of ink whose extent is less than `shortest` pixels. A spot are
/// the pixels of at least `threshold` (1 to 255) that hang together by sides or corners; its extent is one
/// more than the diagonal of the box around the centers of its pixels, so that one pixel has 1 and a straight
/// row of n has n. Spots at a cut border stay, as their extent is not known.
///
/// Ink that is fainter than the threshold, like the soft rim of a line, stays with a spot that it touches and
/// goes with the last; where it touches none, it is a spot itself.
///
/// The same on any number of threads, and a mirrored picture gives the mirrored result.
/// \throws std::invalid_argument as InkImage::check
void removeSpeckles(
  const InkImage& image, float shortest, unsigned char threshold, const CutBorders& cut = {});

} // namespace ink
