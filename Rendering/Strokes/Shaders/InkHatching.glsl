// SPDX-License-Identifier: BSD-3-Clause
#include "InkLighting.glsl"

// The tone of a surface and the strokes that make it, as Common/Tone/Hatching has them.

uniform vec2 hatchSpacing; // pixels, and view units in addition
uniform float crosshatching;
uniform float silhouetteWeight;
uniform vec2 truncations; // of the diffuse and the silhouette term
uniform float toneBias;
uniform float darkest;
uniform samplerBuffer spacingRatios; // two texels for each point of strokes
uniform float cullingCosine; // what faces away from the eye by more is not drawn; 1: both sides are

// As in Common/Tone/Hatching.
const float leastBias = 0.02;
const float fading = 0.25;
const float thinning = 0.1;

float truncated(float intensity, float level)
{
  return level < 1.0 ? max(intensity - level, 0.0) / (1.0 - level) : 0.0;
}

// The share of the paper that ink is to cover.
float hatchTone(vec3 position, vec3 normal, float cosine)
{
  float largestCosine;
  bool fromBehind = cosine < 0.0 && cullingCosine >= 1.0;
  float lit = lightOn(position, fromBehind ? -normal : normal, 1.0, largestCosine);
  float diffuse = truncated(1.0 - lit, truncations.x);
  float silhouette = truncated(1.0 - min(abs(cosine), 1.0), truncations.y);
  float combined = mix(diffuse, silhouette, silhouetteWeight);
  float b = clamp(toneBias, leastBias, 1.0 - leastBias);
  return darkest * combined / ((1.0 / b - 2.0) * (1.0 - combined) + 1.0);
}

// The part of it that is a family's, the second one if that is positive.
float hatchCoverage(float tone, float family)
{
  float single = 1.0 - crosshatching;
  if (tone <= single)
  {
    return family > 0.0 ? 0.0 : tone;
  }
  float left = sqrt(max(1.0 - tone, 0.0) / (1.0 - single));
  return family > 0.0 ? 1.0 - left : 1.0 - (1.0 - single) * left;
}

// How much nearer to each other strokes are in the picture than on a surface: it makes areas smaller by the cosine, and
// lengths along the strokes by less.
float foreshortening(float cosine, vec3 way, vec3 toEye)
{
  float whole = length(way);
  float along = whole > 0.0 ? length(cross(way, toEye)) / whole : 1.0;
  return min(abs(cosine) / max(along, 1e-6), 1.0);
}

// How far strokes are from each other at a point of them when a fraction of them is drawn, relative to the mean.
float spacingRatio(int point, float fraction)
{
  float at = clamp(2.0 * log2(1.0 / ((1.0 - fading) * fraction)), 0.0, 7.0);
  vec4 few = texelFetch(spacingRatios, 2 * point + (at < 4.0 ? 0 : 1));
  // Beside the fourth is the fifth.
  vec4 others = at < 3.0 || at >= 4.0 ? few : texelFetch(spacingRatios, 2 * point + 1);
  int before = int(min(at, 6.0));
  return mix(few[before & 3], others[(before + 1) & 3], at - float(before));
}

// No more than this where the surface is seen at that cosine: beside a silhouette wide strokes would reach over it.
float mostSpacingRatio(float cosine)
{
  return 1.0 + 2.0 * abs(cosine);
}

float strokeWidth(
  float coverage, float allSpacing, float priority, float spacing, float leastWidth, int point, float mostRatio)
{
  if (!(coverage > 0.0 && allSpacing > 0.0 && spacing > 0.0))
  {
    return 0.0;
  }
  float fraction = allSpacing / max(spacing, leastWidth / max(coverage, thinning));
  float from = (1.0 - fading) * fraction;
  float to = (1.0 + fading) * fraction;
  float range = to - from;
  float beyond = max(to - 1.0, 0.0);
  float drawn = from >= 1.0 ? 1.0 : fraction - 0.5 * beyond * beyond / range;
  float presence = clamp((to - priority) / range, 0.0, 1.0);
  return coverage * allSpacing / drawn * presence * min(spacingRatio(point, fraction), mostRatio);
}
