// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

//INK::Features

// The two diffuse shading images I1 and I2 (Zhang et al. 2014, equation 1), from the sums over the splats.
// With INK_COARSE, large splats were summed up in coarser images; their sums are brought to the pixels from
// those of the four nearest texels that stand for the same piece of surface. With INK_OUTLINE, what is beyond
// the surface's border counts as black in the narrow image, so that a line is along it also where the surface
// ends without turning away from the viewer.

#include "InkViewUniforms.glsl"

in vec2 texCoord;

uniform sampler2D surface;
uniform sampler2D sums; // sum w1 f, sum w1, sum w2 f, sum w2
#ifdef INK_COARSE
uniform sampler2D coarseSums[INK_COARSE]; // of texels of 2, 4, ... pixels
uniform vec2 tolerances; // of the depth test: view units, and by slope, view units where clip w is 1
#endif

#ifdef INK_OUTLINE
uniform float outline; // pixels, how far beyond is looked
#endif

//VTK::Output::Dec

#ifdef INK_OUTLINE
bool isCovered(ivec2 pixel)
{
  return texelFetch(surface, clamp(pixel, ivec2(0), textureSize(surface, 0) - 1), 0).g != 0.0;
}

// The share of the pixels around one that the surface covers, but for what holes between few discs may take.
float coverage(ivec2 pixel)
{
  int far = int(ceil(outline));
  int near = int(floor(0.7 * outline));
  if (isCovered(pixel + ivec2(far, 0)) && isCovered(pixel - ivec2(far, 0)) && isCovered(pixel + ivec2(0, far)) &&
    isCovered(pixel - ivec2(0, far)) && isCovered(pixel + ivec2(near, near)) && isCovered(pixel - ivec2(near, near)) &&
    isCovered(pixel + ivec2(near, -near)) && isCovered(pixel - ivec2(near, -near)))
  {
    return 1.0;
  }
  float covered = 0.0;
  float all = 0.0;
  for (int y = -far; y <= far; ++y)
  {
    for (int x = -far; x <= far; ++x)
    {
      float weight = clamp(outline + 0.5 - length(vec2(x, y)), 0.0, 1.0);
      all += weight;
      covered += weight > 0.0 && isCovered(pixel + ivec2(x, y)) ? weight : 0.0;
    }
  }
  return min(covered / (0.9 * all), 1.0);
}
#endif

#ifdef INK_COARSE
vec4 bring(sampler2D coarse, float texel, vec2 pixel, vec2 shown)
{
  vec2 position = pixel / texel - 0.5;
  ivec2 corner = ivec2(floor(position));
  vec2 part = position - vec2(corner);
  ivec2 last = textureSize(coarse, 0) - 1;
  ivec2 lastPixel = textureSize(surface, 0) - 1;
  float bySlope = texel * tolerances.y * clipDepth(-shown.r).y;
  vec4 sum = vec4(0.0);
  float total = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    ivec2 offset = ivec2(i & 1, i >> 1);
    ivec2 at = clamp(corner + offset, ivec2(0), last);
    // The pixel whose surface the texel's splats were tested against.
    vec2 other = texelFetch(surface, min(ivec2(texel * (vec2(at) + 0.5)), lastPixel), 0).rg;
    float slope = max(abs(shown.g), abs(other.g)) - 1.0;
    if (shown.g * other.g > 0.0 && abs(other.r - shown.r) <= tolerances.x + bySlope * slope)
    {
      vec2 share = mix(1.0 - part, part, vec2(offset));
      sum += share.x * share.y * texelFetch(coarse, at, 0);
      total += share.x * share.y;
    }
  }
  return total > 0.0 ? sum / total : sum;
}
#endif

void main()
{
  vec2 position = texCoord * vec2(textureSize(surface, 0));
  ivec2 pixel = ivec2(position);
  vec4 all = texelFetch(sums, pixel, 0);
#ifdef INK_COARSE
  vec2 shown = texelFetch(surface, pixel, 0).rg;
  if (shown.g != 0.0)
  {
    all += bring(coarseSums[0], 2.0, position, shown);
#if INK_COARSE > 1
    all += bring(coarseSums[1], 4.0, position, shown);
#endif
  }
#endif
  vec2 shading = all.y > 0.0 && all.w > 0.0 ? vec2(all.x / all.y, all.z / all.w) : vec2(0.0);
#ifdef INK_OUTLINE
  if (shading.y > 0.0 && isCovered(pixel))
  {
    shading.x *= coverage(pixel);
  }
#endif
  gl_FragData[0] = vec4(shading, 0.0, 0.0);
}
