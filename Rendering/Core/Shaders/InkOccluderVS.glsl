// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INK::Features

// The surface that hides marks: only its depth counts.

#include "InkClipping.glsl"
#include "InkViewUniforms.glsl"

in vec3 pointMC;

out float keptVSOutput; // negative: cut off by a clipping plane

void main()
{
  vec4 position = MCVCMatrix * vec4(pointMC, 1.0);
  keptVSOutput = clipDistance(position);
  gl_Position = VCDCMatrix * position;
}
