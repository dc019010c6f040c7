// SPDX-License-Identifier: BSD-3-Clause
// Ink over the area of a pixel, from what its middle and those of its neighbors show. Within a surface H goes on
// smoothly; where two meet, each part of the pixel is of the one that most of what is around it belongs to.
#include "InkViewUniforms.glsl"

uniform sampler2D surface; // of the layer, from the depth splats
uniform vec2 tolerances;   // of the depth test: view units, and by slope, view units where clip w is 1

const int samples = 4; // along each side of the pixel

// The ramp of the hardest ink.
const float steepest = 0.05;

// phi H from which on ink is full for eight bits.
const float full = 3.5;

// The step from a pixel to one of the nine around it, row by row.
ivec2 stepTo(int i)
{
  return ivec2(i % 3, i / 3) - 1;
}

// Of the pixels before, here and after, how much each counts at x between -1/2 and 1/2.
vec3 nearness(float x)
{
  return exp(-1.4 * vec3((x + 1.0) * (x + 1.0), x * x, (x - 1.0) * (x - 1.0)));
}

// The factors of three values in the parabola through them, at x between -1 and 1.
vec3 parabola(float x)
{
  return vec3(0.5 * x * (x - 1.0), 1.0 - x * x, 0.5 * x * (x + 1.0));
}

float averageInk(ivec2 pixel)
{
  ivec2 last = textureSize(surface, 0) - 1;
  float h[9];
  float least = 2.0;
  float most = -2.0;
  for (int i = 0; i < 9; ++i)
  {
    vec2 shading = texelFetch(illumination, clamp(pixel + stepTo(i), ivec2(0), last), 0).rg;
    h[i] = shading.r - tau * shading.g;
    least = min(least, h[i]);
    most = max(most, h[i]);
  }
  // Between pixels H does not go beyond theirs by more than this.
  float beyond = 0.5 * (most - least);
  if (least - beyond >= 0.0)
  {
    return 0.0;
  }
  if (phi * (most + beyond) < -full)
  {
    return 1.0;
  }

  vec2 shown = texelFetch(surface, pixel, 0).rg;
  float bySlope = shown.g != 0.0 ? tolerances.y * clipDepth(-shown.r).y : 0.0;
  bool same[9]; // as the middle one
  bool edge = false;
  for (int i = 0; i < 9; ++i)
  {
    vec2 other = texelFetch(surface, clamp(pixel + stepTo(i), ivec2(0), last), 0).rg;
    float slope = max(abs(shown.g), abs(other.g)) - 1.0;
    same[i] = shown.g == 0.0 ? other.g == 0.0
                             : shown.g * other.g > 0.0 &&
        abs(other.r - shown.r) <= tolerances.x + bySlope * slope;
    edge = edge || !same[i];
  }
  float others[9]; // ink
  if (edge)
  {
    for (int i = 0; i < 9; ++i)
    {
      others[i] = same[i] ? 0.0 : harden(inkOf(h[i]), steepest);
    }
    // Where the surface goes on unseen, so does H.
    for (int i = 1; i < 9; i += 2)
    {
      h[i] = same[i] ? h[i] : same[8 - i] ? 2.0 * h[4] - h[8 - i] : h[4];
    }
    for (int i = 0; i < 9; i += i == 2 ? 4 : 2)
    {
      h[i] = same[i] ? h[i] : h[i < 3 ? 1 : 7] + h[i % 3 == 0 ? 3 : 5] - h[4];
    }
  }

  float sum = 0.0;
  for (int u = 0; u < samples; ++u)
  {
    float x = (float(u) + 0.5) / float(samples) - 0.5;
    vec3 column = parabola(x) * mat3(h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7], h[8]);
    vec3 across = nearness(x);
    for (int v = 0; v < samples; ++v)
    {
      float y = (float(v) + 0.5) / float(samples) - 0.5;
      float ink = shown.g == 0.0 ? 0.0 : harden(inkOf(dot(parabola(y), column)), steepest);
      if (edge)
      {
        vec3 along = nearness(y);
        float majority = 0.0;
        float nearest = 0.0;
        float other = 0.0;
        for (int i = 0; i < 9; ++i)
        {
          float weight = across[i % 3] * along[i / 3];
          majority += same[i] ? weight : -weight;
          if (!same[i] && weight > nearest)
          {
            nearest = weight;
            other = others[i];
          }
        }
        ink = majority >= 0.0 ? ink : other;
      }
      sum += ink;
    }
  }
  return sum / float(samples * samples);
}
