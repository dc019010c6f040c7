//VTK::System::Dec

// Illumination splatting (Zhang et al. 2014, section 3.2, equations 1 and 2), both images at once: the sums
// of w f and of w over the discs on the visible surface, for the narrow and for the wide Gaussian.

flat in vec2 centerVSOutput;
flat in vec4 toDiscVSOutput;
flat in vec2 perspectiveVSOutput;
flat in vec3 positionVSOutput;
flat in vec3 axisUVSOutput;
flat in vec3 axisVVSOutput;
flat in float lightVSOutput;
flat in float weightVSOutput;
flat in float toleranceVSOutput;

uniform sampler2D depthImage;
uniform vec2 depthRange;
uniform vec2 falloff; // 1 / (2 sigma^2) of the narrow and of the wide Gaussian

//VTK::Output::Dec

void main()
{
  vec2 flatDisc = mat2(toDiscVSOutput.xy, toDiscVSOutput.zw) * (gl_FragCoord.xy - centerVSOutput);
  float perspective = 1.0 - dot(perspectiveVSOutput, flatDisc);
  vec2 disc = flatDisc / perspective;
  float distance2 = dot(disc, disc);
  if (perspective <= 0.0 || distance2 > 1.0)
  {
    discard;
  }
  float depth = -(positionVSOutput.z + disc.x * axisUVSOutput.z + disc.y * axisVVSOutput.z);
  float stored = texelFetch(depthImage, ivec2(gl_FragCoord.xy), 0).r;
  if (stored >= 1.0 || abs(mix(depthRange.x, depthRange.y, stored) - depth) > toleranceVSOutput)
  {
    discard;
  }
  vec2 w = weightVSOutput * exp(-falloff * distance2);
  gl_FragData[0] = vec4(w.x * lightVSOutput, w.x, w.y * lightVSOutput, w.y);
}
