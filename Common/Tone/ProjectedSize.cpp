#include "Tone/ProjectedSize.h"

#include <algorithm>

namespace ink
{

float maximumStipples(float elementSize, float pixelSize, float pixelsPerStipple)
{
  constexpr float mostPixels = 1e6f;
  const float pixels = std::min(elementSize / pixelSize, mostPixels);
  return pixels * pixels / pixelsPerStipple;
}

} // namespace ink
