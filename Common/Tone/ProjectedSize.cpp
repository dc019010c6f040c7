#include "Tone/ProjectedSize.h"

#include <algorithm>

namespace ink
{

float maximumStipples(float elementSize, float pixelSize, float pixelsPerStipple)
{
  constexpr float most = 1e6f;
  const float pixels = std::min(elementSize / pixelSize, most);
  return std::min(pixels * pixels / pixelsPerStipple, most);
}

} // namespace ink
