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
flat in float slopeVSOutput;
flat in vec2 toleranceVSOutput;

uniform sampler2D surface; // from the depth splats
uniform float minimumLight;
uniform vec2 falloff;      // 1 / (2 sigma^2) of the narrow and of the wide Gaussian
uniform vec2 rim;          // both Gaussians at the disc's rim; 0 to leave them as they are

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
  // Only discs on the surface that the depth splats show. Near a contour that surface falls away within a
  // pixel: there, what lies as steeply may lie further behind. Seen from behind, f changes its sign.
  vec2 shown = texelFetch(surface, ivec2(gl_FragCoord.xy), 0).rg;
  float light = sign(shown.g) * lightVSOutput;
  float depth = -(positionVSOutput.z + disc.x * axisUVSOutput.z + disc.y * axisVVSOutput.z);
  float slope = min(abs(shown.g) - 1.0, slopeVSOutput);
  if (light <= minimumLight ||
    abs(shown.r - depth) > toleranceVSOutput.x + toleranceVSOutput.y * slope)
  {
    discard;
  }
  // Less their value at the rim, where the Gaussians would break off: the wide one at 0.3 of its peak,
  // which would show as noise in the lines.
  vec2 w = weightVSOutput * (exp(-falloff * distance2) - rim);
  // Beyond a contour, where f is negative, the surface counts as black, and only in the narrow image. That
  // makes contours solid lines also where few points lie on them; everything else is as in equation 1.
  float f = max(light, 0.0);
  w.y *= step(0.0, light);
  gl_FragData[0] = vec4(w.x * f, w.x, w.y * f, w.y);
}
