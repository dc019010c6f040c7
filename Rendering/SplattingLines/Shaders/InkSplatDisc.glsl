// SPDX-License-Identifier: BSD-3-Clause
// The disc that a fragment shader draws; InkSplatVS.glsl says more.
flat in vec4 toDiscVSOutput;
flat in vec4 centerVSOutput;
flat in vec4 discVSOutput;
#ifdef INK_EDGES
flat in vec3 firstEdgeVSOutput;
flat in vec3 secondEdgeVSOutput;
#endif
#ifdef INK_PLANES
flat in vec3 positionVSOutput;
flat in vec3 axisUVSOutput;
flat in vec3 axisVVSOutput;
#include "InkClipping.glsl"
#endif

// Whether a pixel lies on the disc, and where, in disc coordinates.
bool findOnDisc(vec2 pixel, out vec2 disc)
{
  vec2 flatDisc = mat2(toDiscVSOutput.xy, toDiscVSOutput.zw) * (pixel - centerVSOutput.xy);
  float perspective = 1.0 - dot(centerVSOutput.zw, flatDisc);
  disc = flatDisc / perspective;
#ifdef INK_EDGES
  vec2 fromCenter = pixel - centerVSOutput.xy;
  if (dot(firstEdgeVSOutput.xy, fromCenter) > firstEdgeVSOutput.z ||
    dot(secondEdgeVSOutput.xy, fromCenter) > secondEdgeVSOutput.z)
  {
    return false;
  }
#endif
  return !(perspective <= 0.0 || dot(disc, disc) > 1.0);
}

// View z at a position on the disc.
float depthOnDisc(vec2 disc)
{
  return discVSOutput.x + dot(disc, discVSOutput.yz);
}

// Whether a clipping plane cuts off a position on the disc.
bool isClipped(vec2 disc)
{
#ifdef INK_PLANES
  vec3 position = positionVSOutput + disc.x * axisUVSOutput + disc.y * axisVVSOutput;
  return clipDistance(vec4(position, 1.0)) < 0.0;
#else
  return false;
#endif
}
