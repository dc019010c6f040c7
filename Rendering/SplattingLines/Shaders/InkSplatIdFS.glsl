// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

//INK::Features

// Hardware selection: the nearest disc in the color that the selector asks for.

#include "InkIds.glsl"
#include "InkSplatDisc.glsl"
#include "InkViewUniforms.glsl"

flat in float splatVSOutput;
flat in int idVSOutput;

uniform vec2 viewportOrigin; // pixels

//VTK::Output::Dec

void main()
{
  vec2 disc;
  if (!findOnDisc(gl_FragCoord.xy - viewportOrigin, disc) || isClipped(disc))
  {
    discard;
  }
  // The selector may have drawn the scene's depth before: come just in front of it.
  vec2 clip = clipDepth(depthOnDisc(disc) + splatVSOutput);
  float depth = 0.5 * clip.x / clip.y + 0.5;
  if (clip.y <= 0.0 || depth < 0.0 || depth > 1.0)
  {
    discard;
  }
  gl_FragDepth = depth;
  gl_FragData[0] = idColor(idVSOutput);
}
