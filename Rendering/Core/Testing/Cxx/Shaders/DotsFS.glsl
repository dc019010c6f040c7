// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INK::Features

#ifdef INK_IDS
#include "InkIds.glsl"
#endif

flat in int idVSOutput;

uniform vec3 inkColor;

//VTK::Output::Dec

void main()
{
  if (length(gl_PointCoord - 0.5) > 0.5)
  {
    discard;
  }
#ifdef INK_IDS
  gl_FragData[0] = idColor(idVSOutput);
#else
  gl_FragData[0] = vec4(inkColor, 1.0);
#endif
}
