//VTK::System::Dec

// Depth splatting (Zhang et al. 2014, section 3.1): of the nearest disc in each pixel, the distance from the
// eye along the view, and 1 + its slope against the viewer, negative where it faces away.

flat in vec2 centerVSOutput;
flat in vec4 toDiscVSOutput;
flat in vec2 perspectiveVSOutput;
flat in vec3 positionVSOutput;
flat in vec3 axisUVSOutput;
flat in vec3 axisVVSOutput;
flat in float lightVSOutput;
flat in float slopeVSOutput;

uniform vec2 depthRange; // view units
uniform int clipPlaneCount;
uniform vec4 clipPlanesVC[6];

//VTK::Output::Dec

void main()
{
  vec2 flatDisc = mat2(toDiscVSOutput.xy, toDiscVSOutput.zw) * (gl_FragCoord.xy - centerVSOutput);
  float perspective = 1.0 - dot(perspectiveVSOutput, flatDisc);
  vec2 disc = flatDisc / perspective;
  if (perspective <= 0.0 || dot(disc, disc) > 1.0)
  {
    discard;
  }
  vec3 position = positionVSOutput + disc.x * axisUVSOutput + disc.y * axisVVSOutput;
  for (int i = 0; i < clipPlaneCount; ++i)
  {
    if (dot(clipPlanesVC[i], vec4(position, 1.0)) < 0.0)
    {
      discard;
    }
  }
  float depth = (-position.z - depthRange.x) / (depthRange.y - depthRange.x);
  if (depth < 0.0 || depth >= 1.0)
  {
    discard;
  }
  gl_FragDepth = depth;
  gl_FragData[0] = vec4(-position.z, lightVSOutput < 0.0 ? -1.0 - slopeVSOutput : 1.0 + slopeVSOutput, 0.0, 0.0);
}
