// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INK::Features

// A round dot with a soft rim of one pixel.

flat in vec4 dotVSOutput; // center and radius in pixels, intensity
#ifdef INK_COLORS
flat in vec3 colorVSOutput;
#endif

uniform vec2 viewportOrigin; // pixels
uniform float actorOpacity;
uniform vec3 inkColor;

//VTK::DepthPeeling::Dec

//VTK::Output::Dec

void main()
{
  float distance = length(gl_FragCoord.xy - viewportOrigin - dotVSOutput.xy);
  float coverage = dotVSOutput.w * actorOpacity * clamp(dotVSOutput.z + 0.5 - distance, 0.0, 1.0);
  // However pale: many pale stipples make a gray.
  if (coverage <= 0.0)
  {
    discard;
  }
  //INK::Depth

  //VTK::DepthPeeling::PreColor

#ifdef INK_COLORS
  gl_FragData[0] = vec4(colorVSOutput, coverage);
#else
  gl_FragData[0] = vec4(inkColor, coverage);
#endif

  //VTK::DepthPeeling::Impl
}
