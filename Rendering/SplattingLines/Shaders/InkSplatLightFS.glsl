// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

//INK::Features

// Illumination splatting (Zhang et al. 2014, section 3.2, equations 1 and 2), both images at once: the sums
// of w f and of w over the discs on the visible surface, for the narrow and for the wide Gaussian.

#include "InkSplatDisc.glsl"
flat in vec4 splatVSOutput;
#ifdef INK_COARSE
flat in vec4 gaussiansVSOutput;
#endif

uniform sampler2D surface; // of the layer, from the depth splats
uniform float texel;       // the side of what is drawn into, in the surface's pixels
uniform vec2 nearness;   // the part of the depth test's tolerance that holds in the middle and at the rim
uniform float minimumLight;
uniform float leastLight; // what f is raised to; below it only the narrow image counts a disc
uniform bool bySplat;     // whether a disc's own test (see the vertex shader) holds for all of it
#ifndef INK_COARSE
uniform vec2 falloff;      // 1 / (2 sigma^2) of the narrow and of the wide Gaussian
uniform vec2 rim;          // both Gaussians at the disc's rim; 0 to leave them as they are
#endif

//VTK::Output::Dec

void main()
{
  vec2 pixel = texel * gl_FragCoord.xy;
  vec2 disc;
  if (!findOnDisc(pixel, disc))
  {
    discard;
  }
  float distance2 = dot(disc, disc);
  // Only discs on the surface that the depth splats show. Near a contour that surface falls away within a
  // pixel: there, what lies as steeply may lie further behind. Seen from behind, f changes its sign.
  vec2 shown = texelFetch(surface, min(ivec2(pixel), textureSize(surface, 0) - 1), 0).rg;
  float light = shown.g < 0.0 ? -discVSOutput.w : discVSOutput.w;
  float depth = -depthOnDisc(disc);
  float slope = min(abs(shown.g) - 1.0, splatVSOutput.y);
  float part = min(mix(nearness.x, nearness.y, distance2) * length(vec2(1.0, slope)), 1.0);
  float tolerance = splatVSOutput.z * part + splatVSOutput.w * slope;
  bool elsewhere = abs(shown.r - depth) > tolerance;
  if (light <= minimumLight || (elsewhere && !bySplat))
  {
    discard;
  }
  // Less their value at the rim, where the Gaussians would break off: the wide one at 0.3 of its peak,
  // which would show as noise in the lines.
#ifdef INK_COARSE
  vec2 falloff = gaussiansVSOutput.xy;
  vec2 w = splatVSOutput.x * gaussiansVSOutput.zw * (exp(-falloff * distance2) - exp(-falloff));
#else
  vec2 w = splatVSOutput.x * (exp(-falloff * distance2) - rim);
#endif
  // Beyond a contour, where f is negative, the surface counts as black, and only in the narrow image. That
  // makes contours solid lines also where few points lie on them; everything else is as in equation 1. As
  // published, f may be negative.
  float f = max(light, leastLight);
  w.y *= step(leastLight, light);
  gl_FragData[0] = vec4(w.x * f, w.x, w.y * f, w.y);
}
