// SPDX-License-Identifier: BSD-3-Clause
// Clipping planes, as InkViewUniforms sets them; INK_PLANES is their number where there are any.
#ifdef INK_PLANES
uniform vec4 clipPlanesVC[INK_PLANES]; // the kept side positive
#endif

// Negative for what is cut off; otherwise the distance from the nearest plane, 1 at most.
float clipDistance(vec4 positionVC)
{
  float nearest = 1.0;
#ifdef INK_PLANES
  for (int i = 0; i < INK_PLANES; ++i)
  {
    nearest = min(nearest, dot(clipPlanesVC[i], positionVC));
  }
#endif
  return nearest;
}
