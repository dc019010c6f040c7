// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

//INK::Features

// The ink of one layer (Zhang et al. 2014, section 3.3): H = I1 - tau I2, E = tanh(phi H), ink where E is
// negative; its color times its coverage, and the coverage. With INK_COVERAGE, the coverage was worked on as
// an image. With INK_AREA, ink is averaged over the pixel.

in vec2 texCoord;

uniform sampler2D illumination; // I1, I2
uniform float tau;
uniform float phi;
uniform float hardness; // 0: as published; 1: all ink or none
uniform vec3 inkColor;
uniform float strength;
#ifdef INK_COVERAGE
uniform sampler2D coverageImage;
#endif
#ifdef INK_COLORS
uniform sampler2D colors; // of the nearest discs; alpha 0 where there are none
uniform int reach;        // pixels by which lines may go beyond the surface
#endif
#ifdef INK_TONE
uniform vec3 toneColor; // where the light falls straight on the surface
#endif

//VTK::Output::Dec

float inkOf(float h)
{
  // tanh overflows on some drivers.
  return max(0.0, -tanh(clamp(phi * h, -9.0, 9.0)));
}

// Steeper about one half, though no steeper than some ramp.
float harden(float ink, float ramp)
{
  return hardness > 0.0 ? clamp((ink - 0.5) / max(1.0 - hardness, ramp) + 0.5, 0.0, 1.0) : ink;
}

#ifdef INK_AREA
#include "InkSplatPixelArea.glsl"
#endif

void main()
{
  ivec2 pixel = ivec2(texCoord * vec2(textureSize(illumination, 0)));
  vec2 shading = texelFetch(illumination, pixel, 0).rg;
#ifdef INK_COVERAGE
  float ink = texelFetch(coverageImage, pixel, 0).r;
#elif defined INK_AREA
  float ink = averageInk(pixel);
#else
  float ink = inkOf(shading.r - tau * shading.g);
  // At the hardest the step is a pixel wide.
  ink = harden(ink, clamp(fwidth(ink), 1e-3, 1.0));
#endif
  vec3 color = inkColor;
#ifdef INK_COLORS
  vec4 found = texelFetch(colors, pixel, 0);
  if (found.a == 0.0 && ink > 0.0)
  {
    // The line belongs to the nearest disc around.
    ivec2 last = textureSize(colors, 0) - 1;
    int nearest = 2 * reach * reach + 1;
    for (int y = -reach; y <= reach; ++y)
    {
      for (int x = -reach; x <= reach; ++x)
      {
        vec4 other = texelFetch(colors, clamp(pixel + ivec2(x, y), ivec2(0), last), 0);
        if (other.a > 0.0 && x * x + y * y < nearest)
        {
          nearest = x * x + y * y;
          found = other;
        }
      }
    }
  }
  color = found.rgb;
#endif
#ifdef INK_TONE
  color = mix(color, toneColor, clamp(shading.r, 0.0, 1.0));
#endif
  ink *= strength;
  gl_FragData[0] = vec4(color * ink, ink);
}
