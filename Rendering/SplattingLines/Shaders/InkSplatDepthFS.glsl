// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

//INK::Features

// Depth splatting (Zhang et al. 2014, section 3.1): of the nearest disc in each pixel, the distance from the
// eye along the view, and 1 + its slope against the viewer, negative where it faces away. With INK_PEEL, of
// the nearest disc behind the layer before (section 5.2).

#include "InkSplatDisc.glsl"
#include "InkViewUniforms.glsl"

#ifdef INK_PEEL
flat in vec3 splatVSOutput;
uniform sampler2D surface; // of the layer before
uniform vec2 nearness;     // the part of the depth test's tolerance that holds in the middle and at the rim
#else
flat in float splatVSOutput;
#endif
#ifdef INK_COLORS
flat in vec4 colorVSOutput;
#endif

//VTK::Output::Dec

void main()
{
  vec2 disc;
  if (!findOnDisc(gl_FragCoord.xy, disc) || isClipped(disc))
  {
    discard;
  }
  float distance = -depthOnDisc(disc);
  float depth = (distance - depthRange.x) / (depthRange.y - depthRange.x);
  if (depth < 0.0 || depth >= 1.0)
  {
    discard;
  }
#ifdef INK_PEEL
  // Discs of one sheet overlap: what lies behind the layer before by no more than the illumination splats'
  // depth test lets through belongs to it. Nothing lies behind the background.
  vec2 before = texelFetch(surface, ivec2(gl_FragCoord.xy), 0).rg;
  float slope = max(abs(before.g) - 1.0, splatVSOutput.x);
  float part = min(mix(nearness.x, nearness.y, dot(disc, disc)) * length(vec2(1.0, slope)), 1.0);
  if (distance <= before.r + splatVSOutput.y * part + splatVSOutput.z * slope)
  {
    discard;
  }
#endif
  gl_FragDepth = depth;
  float ownSlope = splatVSOutput
#ifdef INK_PEEL
                     .x
#endif
    ;
  gl_FragData[0] = vec4(distance, discVSOutput.w < 0.0 ? -1.0 - ownSlope : 1.0 + ownSlope, 0.0, 0.0);
#ifdef INK_COLORS
  gl_FragData[1] = colorVSOutput;
#endif
}
