// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

#include "InkViewUniforms.glsl"

flat in vec4 centerVSOutput;
flat in vec4 discVSOutput;

//VTK::Output::Dec

void main()
{
  vec2 beside = gl_FragCoord.xy - centerVSOutput.xy;
  vec3 form = discVSOutput.yzw;
  // Also for what is not a number, of discs that are seen edge-on.
  if (!(dot(form, vec3(beside.x * beside.x, 2.0 * beside.x * beside.y, beside.y * beside.y)) <= 1.0))
  {
    discard;
  }
  vec2 clip = clipDepth(centerVSOutput.z + dot(vec2(centerVSOutput.w, discVSOutput.x), beside));
  gl_FragDepth = 0.5 * clip.x / clip.y + 0.5;
  gl_FragData[0] = vec4(1.0);
}
