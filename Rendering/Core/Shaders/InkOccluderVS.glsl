// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INK::Features

// The surface that hides marks: only its depth counts.

#include "InkViewUniforms.glsl"

in vec3 pointMC;

#ifdef INK_PLANES
out vec3 positionVSOutput; // in view coordinates
#endif

void main()
{
  vec4 position = MCVCMatrix * vec4(pointMC, 1.0);
#ifdef INK_PLANES
  positionVSOutput = position.xyz;
#endif
  gl_Position = VCDCMatrix * position;
}
