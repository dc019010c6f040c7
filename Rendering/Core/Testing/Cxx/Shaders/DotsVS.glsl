// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INK::Features

// A round dot for each point.

#include "InkClipping.glsl"
#include "InkViewUniforms.glsl"

in vec3 pointMC; // in the local frame

uniform float diameter; // pixels

flat out int idVSOutput;

void main()
{
  vec4 position = MCVCMatrix * vec4(pointMC, 1.0);
  // What is cut off lies outside.
  gl_Position = clipDistance(position) < 0.0 ? vec4(2.0, 2.0, 2.0, 1.0) : VCDCMatrix * position;
  gl_PointSize = diameter;
  idVSOutput = gl_VertexID;
}
