// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

#include "InkViewUniforms.glsl"

flat in vec4 centerVSOutput;
flat in vec4 discVSOutput;
flat in vec3 toEyeVSOutput;

//VTK::Output::Dec

void main()
{
  // Where the line of sight, the same for all of a disc, meets the disc's plane.
  vec3 beside = vec3((gl_FragCoord.xy - centerVSOutput.xy) * centerVSOutput.w, 0.0);
  vec3 onPlane = beside - toEyeVSOutput * (dot(discVSOutput.xyz, beside) / dot(discVSOutput.xyz, toEyeVSOutput));
  // Also for what is not a number, of discs that are seen edge-on.
  if (!(dot(onPlane, onPlane) <= discVSOutput.w * discVSOutput.w))
  {
    discard;
  }
  vec2 clip = clipDepth(centerVSOutput.z + onPlane.z);
  gl_FragDepth = 0.5 * clip.x / clip.y + 0.5;
  gl_FragData[0] = vec4(1.0);
}
