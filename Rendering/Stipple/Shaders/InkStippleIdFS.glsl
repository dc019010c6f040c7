//VTK::System::Dec

// Hardware selection: the dots in the colors that the selector asks for.

flat in vec4 dotVSOutput; // center and radius in pixels
flat in int idVSOutput;

uniform vec2 viewportOrigin; // pixels
uniform int idShift;         // the first of the point id's 24 bits to show; negative: show propColor
uniform vec3 propColor;

//VTK::Output::Dec

void main()
{
  if (length(gl_FragCoord.xy - viewportOrigin - dotVSOutput.xy) > dotVSOutput.z + 0.5)
  {
    discard;
  }
  int id = idShift >= 24 ? idVSOutput >> 24 : idVSOutput;
  vec3 idColor = vec3(float(id & 255), float((id >> 8) & 255), float((id >> 16) & 255)) / 255.0;
  gl_FragData[0] = vec4(idShift < 0 ? propColor : idColor, 1.0);
}
