//VTK::System::Dec

// A round dot with a soft rim of one pixel.

flat in vec4 dotVSOutput; // centre and radius in pixels, intensity
flat in vec3 colorVSOutput;

uniform vec2 viewportOrigin; // pixels
uniform float actorOpacity;

//VTK::DepthPeeling::Dec

//VTK::Output::Dec

void main()
{
  float distance = length(gl_FragCoord.xy - viewportOrigin - dotVSOutput.xy);
  float coverage = dotVSOutput.w * actorOpacity * clamp(dotVSOutput.z + 0.5 - distance, 0.0, 1.0);
  // However pale: many pale stipples make a grey.
  if (coverage <= 0.0)
  {
    discard;
  }
  //INK::Depth

  //VTK::DepthPeeling::PreColor

  gl_FragData[0] = vec4(colorVSOutput, coverage);

  //VTK::DepthPeeling::Impl
}
