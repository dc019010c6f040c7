//VTK::System::Dec

// The drawing (Zhang et al. 2014, section 3.3): H = I1 - tau I2, E = tanh(phi H), ink where E is negative.

in vec2 texCoord;

uniform sampler2D surface;   // from the depth splats
uniform sampler2D lightSums; // sum w1 f, sum w1, sum w2 f, sum w2
uniform vec4 depthToClip;    // clip z = x * view z + y, clip w = z * view z + w
uniform float farthest;      // beyond this distance there is no surface
uniform float tau;
uniform float phi;
uniform vec3 inkColor;
uniform vec3 paperColor;
uniform bool paper;
uniform float opacity;
uniform float depthBias; // view units that the marks lie in front of the surface

//VTK::DepthPeeling::Dec

//VTK::Output::Dec

void main()
{
  ivec2 texel = ivec2(texCoord * vec2(textureSize(surface, 0)));
  float depth = texelFetch(surface, texel, 0).r;
  if (depth > farthest)
  {
    discard;
  }
  vec4 sums = texelFetch(lightSums, texel, 0);
  float difference = 0.0;
  if (sums.y > 0.0 && sums.w > 0.0)
  {
    difference = sums.x / sums.y - tau * sums.z / sums.w;
  }
  // tanh overflows on some drivers.
  float ink = max(0.0, -tanh(clamp(phi * difference, -9.0, 9.0)));
  if (!paper && ink * opacity < 0.002) // nothing that eight bits could show
  {
    discard;
  }

  // Half way to the viewer at most: close up, the marks must not end up behind the viewer.
  vec2 clip = depthToClip.xz * (min(depthBias, 0.5 * depth) - depth) + depthToClip.yw;
  gl_FragDepth = clamp(0.5 * clip.x / clip.y + 0.5, 0.0, 1.0);

  //VTK::DepthPeeling::PreColor

  gl_FragData[0] =
    paper ? vec4(mix(paperColor, inkColor, ink), opacity) : vec4(inkColor, ink * opacity);

  //VTK::DepthPeeling::Impl
}
