// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INK::Features

// Lu et al. 2003, sections 4.3 and 5: how many of its element's stipples are drawn, and so whether this one is,
// how large and in which color. Common/Tone has the same in C++, function by function, and says more.
//
// Software rasterizers compute what a condition leaves out, too, and take long over loops of unknown length. So what
// most pictures do without is compiled only where it is needed: INK_COLORS, INK_OCCLUDED, INK_PROBABILITY, INK_IDS,
// INK_RESULTS, INK_PACKED (positions are as Common/Stippling/QuantizedPosition has them).

#include "InkClipping.glsl"
#include "InkHash.glsl"
#include "InkLighting.glsl"
#include "InkViewUniforms.glsl"

#ifdef INK_PACKED
in uint quantizedPosition; // in the element's box, ten bits an axis
uniform samplerBuffer elementBoxes; // lower corner in the local frame, scale
uniform vec3 packedStep;            // at scale 1
#else
in vec3 pointMC;    // in the local frame
#endif
in uint elementAndRank; // the element's number, and in the lowest bits the stipple's rank in its list

uniform int rankBits;
uniform samplerBuffer elementShapes;  // normal, gradient magnitude
uniform samplerBuffer elementValues;  // value, length of the list
uniform usamplerBuffer elementIds;    // first point's id, random value * 2^24
uniform samplerBuffer elementColors;
uniform bool ownColors;               // whether there are elementColors
uniform vec3 inkColor;

uniform float largestPoint; // pixels

// The surface that hides stipples behind it; see the occluder's shaders.
uniform sampler2D occluder;
uniform float occluderMargin; // pixels that it shows on each side of the viewport
uniform float occluderOffset; // view units towards the eye
uniform float occluderPixels; // no more than so many, but for rounded positions
const float paperDistance = 4.0; // pixels

// ink::stipple::Tone::View
uniform float listed;
uniform float maximumStipples;
uniform float smallness;
uniform float nearest;
uniform float middle;
uniform float halfRange;

// ink::stipple::Tone
uniform bool surface;
uniform bool twoSided;
uniform bool boundaryOn;
uniform bool silhouetteOn;
uniform bool resolutionOn;
uniform bool lightingOn;
uniform bool distanceOn;
uniform bool interiorOn;
uniform vec3 boundary;            // k_gc, k_gs, k_ge
uniform vec3 silhouette;          // k_sc, k_ss, k_se
uniform vec2 resolution;          // k_rc, k_nz
uniform vec2 lighting;            // k_le, cosine of the facing angle
uniform bool lightInk;
uniform vec2 distanceK;           // k_de, size
uniform vec2 interior;            // k_ie, size
uniform float fade;
uniform float valueEffect;
uniform bool growWithZoom;
uniform bool fadeBySize;
uniform float diameter;           // pixels
uniform vec3 warm;                // hue, lightness, saturation
uniform vec3 cool;
uniform vec3 warmCool;            // weights of tone and distance, amount

uniform float leastIntensity; // of dots; the framebuffer cannot add up paler ones

// Where INK_RESULTS writes what each stipple comes to instead of drawing it: the size of an image, pixels.
uniform vec2 resultSize;

flat out vec4 dotVSOutput;   // center and radius in pixels, intensity
#ifdef INK_COLORS
flat out vec3 colorVSOutput;
#endif
flat out vec3 toneVSOutput;  // T, opacity, diameter
flat out int idVSOutput;

float thinnedIntensity(float intensity, uint index)
{
  return intensity >= leastIntensity ? intensity
                                     : (intensity > leastIntensity * randomOf(index) ? leastIntensity : 0.0);
}

float distanceFactor(float depth)
{
  float z = clamp(depth, -1.0, 1.0);
  return distanceOn ? 1.0 + (z < 0.0 ? -1.0 : 1.0) * power(abs(z), distanceK.x) : 1.0;
}

float part(float tone, float rank, float random)
{
  float number = tone;
  float width = fade;
#ifdef INK_PROBABILITY
  number += smallness * (random - 0.5);
  width *= 1.0 - smallness;
#else
  width += smallness * (1.0 - width);
#endif
  float beyond = number - rank - 0.5;
  return width < 1e-3 ? step(0.0, beyond) : clamp(beyond / width + 0.5, 0.0, 1.0);
}

vec3 rgbFromHls(vec3 hls)
{
  float amplitude = hls.z * min(hls.y, 1.0 - hls.y);
  vec3 k = 12.0 * fract(hls.x + vec3(0.0, 8.0, 4.0) / 12.0);
  return hls.y - amplitude * clamp(min(k - 3.0, 9.0 - k), -1.0, 1.0);
}

vec3 mixHls(vec3 from, vec3 to, float t)
{
  float fromHue = from.z > 0.0 ? from.x : to.x;
  float toHue = to.z > 0.0 ? to.x : fromHue;
  float way = toHue - fromHue;
  way -= sign(way) * floor(abs(way) + 0.5);
  return vec3(fract(fromHue + t * way), mix(from.yz, to.yz, t));
}

#ifdef INK_RESULTS
void placeResult()
{
  int width = int(resultSize.x);
  vec2 pixel = vec2(float(idVSOutput % width), float(idVSOutput / width)) + 0.5;
  gl_Position = vec4(2.0 * pixel / resultSize - 1.0, 0.0, 1.0);
}
#endif

void placeDot(vec2 centerPixel, float depth, float opacity, float size, uint element)
{
  if (!(opacity > 0.0))
  {
    return;
  }

  // A soft dot with a sharp one's area; see DotCoverage.h.
  float square = 0.25 * size * size;
  float radius = sqrt(max(square, 0.25 + 1.0 / 12.0) - 1.0 / 12.0);
  radius = min(radius, 0.5 * largestPoint - 1.0);
  float intensity = thinnedIntensity(opacity * min(square / (0.25 + 1.0 / 12.0), 1.0), element);
  if (intensity == 0.0)
  {
    return;
  }
  dotVSOutput = vec4(centerPixel, radius, intensity);

  // The part of the dot's box in the viewport: dots whose center lies outside are drawn, too.
  vec2 low = max(centerPixel - radius - 0.5, vec2(0.0));
  vec2 high = min(centerPixel + radius + 0.5, viewportSize);
  if (low.x >= high.x || low.y >= high.y)
  {
    return;
  }
  gl_Position = vec4((low + high) / viewportSize - 1.0, depth, 1.0);
  gl_PointSize = max(high.x - low.x, high.y - low.y);
}

void main()
{
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // outside, for stipples that are left out
  gl_PointSize = 1.0;
  dotVSOutput = vec4(0.0);
  toneVSOutput = vec3(0.0);
  idVSOutput = 0;

  int element = int(elementAndRank >> uint(rankBits));
  int rank = int(elementAndRank & ((1u << uint(rankBits)) - 1u));
  vec4 shape = texelFetch(elementShapes, element);
  vec2 valueLength = texelFetch(elementValues, element).rg;
  float gradientMagnitude = shape.w;
  float value = power(valueLength.x, valueEffect);
  float listLength = valueLength.y;
  float random = 0.0;
#ifdef INK_PROBABILITY
  random = float(texelFetch(elementIds, element).g) / 16777216.0;
#endif

#ifdef INK_PACKED
  vec4 box = texelFetch(elementBoxes, element);
  vec3 pointMC = box.xyz + box.w * packedStep * vec3(quantizedPosition & 1023u, quantizedPosition >> 10u & 1023u, quantizedPosition >> 20u);
#endif
  vec4 position = MCVCMatrix * vec4(pointMC, 1.0);
  vec3 normal = normalize(normalMatrix * shape.xyz);
  vec3 toEye = eyeVC.xyz - eyeVC.w * position.xyz;
  toEye = toEye == vec3(0.0) ? normal : normalize(toEye);
  float distanceFromEye = -position.z;
  float depth = (middle - distanceFromEye) / halfRange;
  float cosine = dot(normal, toEye);
  bool drawn;
  if (surface)
  {
    drawn = twoSided || cosine > 0.0;
    normal = cosine < 0.0 ? -normal : normal;
    cosine = abs(cosine);
  }
  else
  {
    drawn = !lightingOn || cosine >= lighting.y;
  }

  float lightCosine;
  float lit = lightOn(position.xyz, normal, lighting.x, lightCosine);

  // Table 1, in the paper's order.
  float slant = min(abs(cosine), 1.0);
  float factors = 1.0;
  if (!surface && boundaryOn)
  {
    factors *= value * (boundary.x + boundary.y * power(gradientMagnitude, boundary.z));
  }
  if (!surface && silhouetteOn)
  {
    factors *= value * (silhouette.x + silhouette.y * (1.0 - power(slant, silhouette.z)));
  }
  float byDistance = 1.0;
  if (eyeVC.w != 0.0)
  {
    float ratio = max(distanceFromEye / nearest, 1e-4);
    byDistance = power(ratio, ratio < 1.0 ? -2.0 : (resolutionOn ? resolution.x : 0.0));
  }
  factors *= resolutionOn ? power(slant, resolution.y) : 1.0;
  if (lightingOn)
  {
    factors *= lightInk ? lit : 1.0 - lit;
  }
  float distanceT = distanceFactor(depth);
  factors *= distanceT;
  float interiorT = !surface && interiorOn ? power(gradientMagnitude, interior.x) : 1.0;
  factors *= interiorT;

  float room = maximumStipples / listed * byDistance;
  float tone = listLength * (growWithZoom ? min(room, 1.0) : room) * factors;
  float opacity = drawn && float(rank) < listLength ? part(tone, float(rank), random) : 0.0;
  float size = diameter * (1.0 + distanceK.y * (distanceT - 1.0)) * (1.0 + interior.y * (interiorT - 1.0));
  size *= growWithZoom ? sqrt(max(room, 1.0)) : 1.0;
  if (fadeBySize && opacity > 0.0)
  {
    size *= sqrt(opacity);
    opacity = 1.0;
  }

#ifdef INK_COLORS
  vec4 own = ownColors ? texelFetch(elementColors, element) : vec4(inkColor, 1.0);
  opacity *= own.a;
  vec3 color = own.rgb;
  float weights = warmCool.x + warmCool.y;
  if (warmCool.z > 0.0 && weights > 0.0)
  {
    float warmth = (warmCool.x * (0.5 + 0.5 * lightCosine) +
                     warmCool.y * (0.5 + 0.5 * clamp(depth, -1.0, 1.0))) / weights;
    color = mix(color, rgbFromHls(mixHls(cool, warm, warmth)), warmCool.z);
  }
  colorVSOutput = color;
#endif

  vec4 center = VCDCMatrix * position;
  opacity = clipDistance(position) < 0.0 || center.w <= 0.0 ? 0.0 : opacity;
  float dotDepth = center.z / center.w;
  vec2 centerPixel = (0.5 * center.xy / center.w + 0.5) * viewportSize;
#ifdef INK_OCCLUDED
  if (opacity > 0.0)
  {
    // Lifted a little towards the eye, more where the surface is slanted and so farther before it that way, but not
    // behind the eye.
    float offset = occluderPixels * pixelVC * center.w;
#ifdef INK_PACKED
    offset = max(offset, unitVC * box.w * length(packedStep));
#endif
    float lift = min(min(offset, occluderOffset) / max(slant, 0.25), max(0.5 * distanceFromEye, 0.0));
    vec4 lifted = VCDCMatrix * vec4(position.xyz + toEye * lift, 1.0);
    vec2 last = viewportSize + 2.0 * occluderMargin - 1.0;
    float hides = texelFetch(occluder, ivec2(clamp(centerPixel + occluderMargin, vec2(0.0), last)), 0).r;
    opacity = 0.5 * lifted.z / lifted.w + 0.5 > hides ? 0.0 : opacity;
    // What its own surface does not hide is not to be hidden by another drawing of the same surface, lines on paper say.
    lift = min(lift + paperDistance * pixelVC * center.w / max(slant, 0.25), max(0.5 * distanceFromEye, 0.0));
    lifted = VCDCMatrix * vec4(position.xyz + toEye * lift, 1.0);
    // But not before the near plane.
    dotDepth = max(lifted.z / lifted.w, min(dotDepth, -1.0));
  }
#endif
  toneVSOutput = vec3(tone, opacity, size);
#ifdef INK_IDS
  idVSOutput = int(texelFetch(elementIds, element).r) + rank;
#endif
#ifdef INK_RESULTS
  placeResult();
#else
  placeDot(centerPixel, dotDepth, opacity, size, uint(element));
#endif
}
