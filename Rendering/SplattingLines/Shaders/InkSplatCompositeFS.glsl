// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// The drawing before what other actors have drawn: ink on the paper that the surface is, or ink alone.

#include "InkViewUniforms.glsl"

in vec2 texCoord;

uniform sampler2D surface;  // of the layer whose depth counts
uniform sampler2D ink;      // color times coverage, coverage
uniform float farthest;     // beyond this distance there is no surface
uniform vec3 paperColor;
uniform bool paper;
uniform float opacity;
uniform int margin;      // pixels on each side of the images that are not shown
uniform int reach;       // pixels by which lines may go beyond the surface
uniform float depthBias; // view units that the marks lie in front of the surface

//VTK::DepthPeeling::Dec

//VTK::Output::Dec

void main()
{
  ivec2 texel = ivec2(texCoord * vec2(textureSize(surface, 0) - 2 * margin)) + margin;
  float depth = texelFetch(surface, texel, 0).r;
  bool beyond = depth > farthest;
  if (beyond && reach == 0)
  {
    discard;
  }
  vec4 marks = texelFetch(ink, texel, 0);
  if (beyond && marks.a > 0.0)
  {
    // The line belongs to the nearest surface around.
    ivec2 last = textureSize(surface, 0) - 1;
    for (int y = -reach; y <= reach; ++y)
    {
      for (int x = -reach; x <= reach; ++x)
      {
        depth = min(depth, texelFetch(surface, clamp(texel + ivec2(x, y), ivec2(0), last), 0).r);
      }
    }
  }
  if (depth > farthest)
  {
    discard;
  }
  bool alone = beyond || !paper;
  if (alone && marks.a * opacity < 0.002) // nothing that eight bits could show
  {
    discard;
  }

  // Half way to the viewer at most: close up, the marks must not end up behind the viewer.
  vec2 clip = clipDepth(min(depthBias, 0.5 * depth) - depth);
  gl_FragDepth = clamp(0.5 * clip.x / clip.y + 0.5, 0.0, 1.0);

  //VTK::DepthPeeling::PreColor

  gl_FragData[0] = alone ? vec4(marks.rgb / marks.a, marks.a * opacity)
                         : vec4(paperColor * (1.0 - marks.a) + marks.rgb, opacity);

  //VTK::DepthPeeling::Impl
}
