// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// Hardware selection: the dots in the colors that the selector asks for.

#include "InkIds.glsl"

flat in vec4 dotVSOutput; // center and radius in pixels
flat in int idVSOutput;

uniform vec2 viewportOrigin; // pixels

//VTK::Output::Dec

void main()
{
  if (length(gl_FragCoord.xy - viewportOrigin - dotVSOutput.xy) > dotVSOutput.z + 0.5)
  {
    discard;
  }
  gl_FragData[0] = idColor(idVSOutput);
}
