// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

#include "InkViewUniforms.glsl"

in vec3 pointMC;
in vec3 normalMC;

out vec3 positionVSOutput; // in view coordinates
out vec3 normalVSOutput;

void main()
{
  vec4 position = MCVCMatrix * vec4(pointMC, 1.0);
  positionVSOutput = position.xyz;
  normalVSOutput = normalMatrix * normalMC;
  gl_Position = VCDCMatrix * position;
}
