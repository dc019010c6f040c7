//VTK::System::Dec

//INK::Features

// Depth splatting (Zhang et al. 2014, section 3.1): of the nearest disc in each pixel, the distance from the
// eye along the view, and 1 + its slope against the viewer, negative where it faces away. With INK_PEEL, of
// the nearest disc behind the layer before (section 5.2).

flat in vec4 toDiscVSOutput;
flat in vec4 centerVSOutput;
flat in vec4 discVSOutput;
#ifdef INK_PLANES
flat in vec3 positionVSOutput;
flat in vec3 axisUVSOutput;
flat in vec3 axisVVSOutput;
uniform vec4 clipPlanesVC[INK_PLANES];
#endif
#ifdef INK_PEEL
flat in vec3 splatVSOutput;
uniform sampler2D surface; // of the layer before
#else
flat in float splatVSOutput;
#endif
#ifdef INK_COLORS
flat in vec4 colorVSOutput;
#endif

uniform vec2 depthRange; // view units

//VTK::Output::Dec

void main()
{
  vec2 flatDisc = mat2(toDiscVSOutput.xy, toDiscVSOutput.zw) * (gl_FragCoord.xy - centerVSOutput.xy);
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
  float distance = -(discVSOutput.x + dot(disc, discVSOutput.yz));
  float depth = (distance - depthRange.x) / (depthRange.y - depthRange.x);
  if (depth < 0.0 || depth >= 1.0)
  {
    discard;
  }
#ifdef INK_PEEL
  // Discs of one sheet overlap: what lies behind the layer before by no more than the illumination splats'
  // depth test lets through belongs to it. Nothing lies behind the background.
  vec2 before = texelFetch(surface, ivec2(gl_FragCoord.xy), 0).rg;
  if (distance <= before.r + splatVSOutput.y + splatVSOutput.z * max(abs(before.g) - 1.0, splatVSOutput.x))
  {
    discard;
  }
#endif
  gl_FragDepth = depth;
  float slope = splatVSOutput
#ifdef INK_PEEL
                  .x
#endif
    ;
  gl_FragData[0] = vec4(distance, discVSOutput.w < 0.0 ? -1.0 - slope : 1.0 + slope, 0.0, 0.0);
#ifdef INK_COLORS
  gl_FragData[1] = colorVSOutput;
#endif
}
