//VTK::System::Dec

//INK::Features

// Hardware selection: the nearest disc in the color that the selector asks for.

flat in vec4 toDiscVSOutput;
flat in vec4 centerVSOutput;
flat in vec4 discVSOutput;
flat in float splatVSOutput;
flat in int idVSOutput;
#ifdef INK_PLANES
flat in vec3 positionVSOutput;
flat in vec3 axisUVSOutput;
flat in vec3 axisVVSOutput;
uniform vec4 clipPlanesVC[INK_PLANES];
#endif

uniform vec2 viewportOrigin; // pixels
uniform vec4 depthToClip;    // clip z = x * view z + y, clip w = z * view z + w
uniform int idShift;         // the first of the point id's 24 bits to show; negative: show propColor
uniform vec3 propColor;

//VTK::Output::Dec

void main()
{
  vec2 flatDisc =
    mat2(toDiscVSOutput.xy, toDiscVSOutput.zw) * (gl_FragCoord.xy - viewportOrigin - centerVSOutput.xy);
  float perspective = 1.0 - dot(centerVSOutput.zw, flatDisc);
  vec2 disc = flatDisc / perspective;
  if (perspective <= 0.0 || dot(disc, disc) > 1.0)
  {
    discard;
  }
#ifdef INK_PLANES
  vec3 position = positionVSOutput + disc.x * axisUVSOutput + disc.y * axisVVSOutput;
  for (int i = 0; i < INK_PLANES; ++i)
  {
    if (dot(clipPlanesVC[i], vec4(position, 1.0)) < 0.0)
    {
      discard;
    }
  }
#endif
  // The selector may have drawn the scene's depth before: come just in front of it.
  float z = discVSOutput.x + dot(disc, discVSOutput.yz) + splatVSOutput;
  vec2 clip = depthToClip.xz * z + depthToClip.yw;
  float depth = 0.5 * clip.x / clip.y + 0.5;
  if (clip.y <= 0.0 || depth < 0.0 || depth > 1.0)
  {
    discard;
  }
  gl_FragDepth = depth;
  int id = idVSOutput >> max(idShift, 0);
  vec3 idColor = vec3(float(id & 255), float((id >> 8) & 255), float((id >> 16) & 255)) / 255.0;
  gl_FragData[0] = vec4(idShift < 0 ? propColor : idColor, 1.0);
}
