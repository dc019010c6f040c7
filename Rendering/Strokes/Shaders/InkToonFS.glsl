// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INK::Features

// A surface that is ink where its normal is nearly perpendicular to the direction to the eye (Lu et al. 2003, section
// 5.6), and nothing elsewhere.

#include "InkClipping.glsl"
#include "InkViewUniforms.glsl"
#ifdef INK_IDS
#include "InkIds.glsl"
uniform usamplerBuffer pointIds; // of each triangle's first corner
#endif

in vec3 positionVSOutput;
in vec3 normalVSOutput;

uniform vec2 viewportOrigin; // pixels
uniform sampler2D occluder;
uniform float occluderScale;  // its pixels for one of the picture
uniform float occluderMargin; // its pixels
uniform float largestCosine;  // of the angle between normal and eye
uniform float lift;           // pixels
uniform vec3 inkColor;
uniform float actorOpacity;
uniform float leastCoverage;

//VTK::DepthPeeling::Dec

//VTK::Output::Dec

// Whether the surface is hidden here by another part of it. Its own depth may differ from that of a pixel beside it.
bool isHidden()
{
  ivec2 middle = ivec2((gl_FragCoord.xy - viewportOrigin) * occluderScale + occluderMargin);
  ivec2 last = textureSize(occluder, 0) - 1;
  float depth = 0.0;
  for (int y = -1; y <= 1; ++y)
  {
    for (int x = -1; x <= 1; ++x)
    {
      depth = max(depth, texelFetch(occluder, clamp(middle + ivec2(x, y), ivec2(0), last), 0).r);
    }
  }
  return gl_FragCoord.z > depth;
}

void main()
{
  vec3 toEye = normalize(eyeVC.xyz - eyeVC.w * positionVSOutput);
  float cosine = abs(dot(normalize(normalVSOutput), toEye));
  // Smooth within a pixel; with 1 all of it, also what faces the eye.
  float coverage =
    largestCosine < 1.0 ? clamp(0.5 + (largestCosine - cosine) / max(fwidth(cosine), 1e-6), 0.0, 1.0) : 1.0;
  // Also of a normal that is zero.
  if (!(coverage * actorOpacity > leastCoverage) || clipDistance(vec4(positionVSOutput, 1.0)) < 0.0 || isHidden())
  {
    discard;
  }
  float z = positionVSOutput.z;
  vec2 lifted = clipDepth(z + lift * pixelVC * clipDepth(z).y);
  gl_FragDepth = min(0.5 * max(lifted.x / lifted.y, -1.0) + 0.5, gl_FragCoord.z);

  //VTK::DepthPeeling::PreColor

#ifdef INK_IDS
  gl_FragData[0] = idColor(int(texelFetch(pointIds, gl_PrimitiveID).r));
#else
  gl_FragData[0] = vec4(inkColor, coverage * actorOpacity);
#endif

  //VTK::DepthPeeling::Impl
}
