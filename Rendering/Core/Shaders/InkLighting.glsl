// SPDX-License-Identifier: BSD-3-Clause
#include "InkPower.glsl"

// The renderer's lights, as InkLights sets them: INK_LIGHTS of them, of which the first INK_SUNS have parallel rays.
// INK_LAMPS: there are others.
uniform vec4 lightPositions[8];
uniform float lightIntensities[8];
uniform vec4 lampDirections[8]; // and the cosine of the cone's half angle, -1: no cone
uniform vec4 lampFading[8];     // attenuation; the cone's exponent

// How much light falls on a surface, 0 to 1, when each light counts by its cosine to a power; and the largest cosine,
// -1 without lights. See Common/Tone/Stipple/Lighting.h.
float lightOn(vec3 positionVC, vec3 normalVC, float exponent, out float largestCosine)
{
  float lit = 0.0;
  largestCosine = -1.0;
  for (int i = 0; i < INK_LIGHTS; ++i)
  {
    vec3 towards = lightPositions[i].xyz - lightPositions[i].w * positionVC;
    float reach = length(towards);
    float c = reach > 0.0 ? dot(normalVC, towards) / reach : 1.0;
    largestCosine = max(largestCosine, min(c, 1.0));
    float intensity = lightIntensities[i];
#ifdef INK_LAMPS
    if (i >= INK_SUNS)
    {
      vec4 fading = lampFading[i];
      float loss = fading.x + reach * fading.y + reach * reach * fading.z;
      intensity = loss > 0.0 ? intensity / loss : 0.0;
      vec4 cone = lampDirections[i];
      float inCone = reach > 0.0 ? -dot(towards, cone.xyz) / reach : 1.0;
      intensity *= cone.w <= -1.0 ? 1.0 : inCone >= cone.w ? power(min(inCone, 1.0), fading.w) : 0.0;
    }
#endif
    lit += c > 0.0 ? intensity * power(min(c, 1.0), exponent) : 0.0;
  }
  return min(lit, 1.0);
}
