// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INK::Features

#ifdef INK_PLANES
#include "InkClipping.glsl"
in vec3 positionVSOutput;
#endif

//VTK::Output::Dec

void main()
{
#ifdef INK_PLANES
  // At the pixel: between a triangle's corners the nearest plane may be another one.
  if (clipDistance(vec4(positionVSOutput, 1.0)) < 0.0)
  {
    discard;
  }
#endif
  gl_FragData[0] = vec4(1.0);
}
