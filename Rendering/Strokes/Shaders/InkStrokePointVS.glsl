// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INK::Features

// Where the picture has a point of a stroke and how wide the stroke is there: a pixel of an image for each.

#include "InkViewUniforms.glsl"

uniform usamplerBuffer drawnPoints; // source point, share of the way to the next * 2^32, run
uniform isamplerBuffer runs;        // first, last, stroke, flags
uniform samplerBuffer sourcePoints; // position in the local frame, arc length
uniform samplerBuffer sourceShapes; // normal, factor of the width
uniform samplerBuffer strokes;      // arc length at its begin, arc length, priority, whether closed

uniform vec2 imageSize;
uniform vec2 halfWidth; // pixels, and view units in addition
uniform float depthWidth;
uniform vec2 distances; // of the nearest and the farthest stroke, view units
uniform float lift;     // pixels
#ifdef INK_HATCHING
uniform float taper; // share of a stroke's length
#endif

#ifdef INK_HATCHING
#include "InkHatching.glsl"
uniform samplerBuffer hatches; // distance of all strokes of the family in the local frame, family
#endif
#ifdef INK_VOXELS
#include "InkVoxelSegment.glsl"
#endif
#ifdef INK_EDGES
#include "InkBackEdge.glsl"
#endif

flat out vec4 placeVSOutput; // clip coordinates, lifted
flat out vec4 shapeVSOutput; // half width in pixels, arc length, the stroke's length if it is open

// The lift is larger on a slanted surface, up to this; without a normal, too.
const float leastSlant = 0.25;

#ifdef INK_HATCHING
vec3 positionOf(int drawnPoint)
{
  return (MCVCMatrix * vec4(texelFetch(sourcePoints, int(texelFetch(drawnPoints, drawnPoint).x)).xyz, 1.0)).xyz;
}

// Rossl's epsilon: beyond, a surface is seen from behind; up to there, it is just behind its silhouette.
const float behindSilhouette = 0.2;

// The width in pixels that the tone at a point of a stroke asks for.
float toneWidth(vec3 position, vec3 normal, vec3 toEye, float pixel, ivec4 run, float priority, int source)
{
  float cosine = normal == vec3(0.0) ? 1.0 : dot(normal, toEye);
  bool twoSided = cullingCosine >= 1.0;
  if (cosine < -cullingCosine || (twoSided && cosine < 0.0 && cosine > -behindSilhouette))
  {
    return 0.0;
  }
  vec3 way = positionOf(min(gl_VertexID + 1, run.y)) - positionOf(max(gl_VertexID - 1, run.x));
  vec2 hatch = texelFetch(hatches, run.z).xy;
  float allSpacing = hatch.x * unitVC * foreshortening(cosine, way, toEye) / pixel;
  float spacing = hatchSpacing.x + hatchSpacing.y / pixel;
  float least = 2.0 * (halfWidth.x + halfWidth.y / pixel);
  float coverage = hatchCoverage(hatchTone(position, normal, cosine), hatch.y);
  return strokeWidth(coverage, allSpacing, priority, spacing, least, source, mostSpacingRatio(cosine));
}
#endif

void main()
{
  uvec4 drawn = texelFetch(drawnPoints, gl_VertexID);
  int source = int(drawn.x);
  vec4 point = texelFetch(sourcePoints, source);
  vec4 shape = texelFetch(sourceShapes, source);
  if (drawn.y > 0u)
  {
    float share = float(drawn.y) / 4294967296.0;
    point = mix(point, texelFetch(sourcePoints, source + 1), share);
    shape = mix(shape, texelFetch(sourceShapes, source + 1), share);
  }

#ifdef INK_VOXELS
  float whole;
  bool found = findSegmentEnd(source % 2, point, shape, whole);
#endif
#ifdef INK_EDGES
  bool found = findBackNormal(source, shape.xyz);
#endif

  vec4 position = MCVCMatrix * vec4(point.xyz, 1.0);
  vec3 toEye = eyeVC.xyz - eyeVC.w * position.xyz;
  toEye = toEye == vec3(0.0) ? vec3(0.0, 0.0, 1.0) : normalize(toEye);
  vec3 normal = normalMatrix * shape.xyz;
  float cosine = normal == vec3(0.0) ? 0.0 : dot(normalize(normal), toEye);
  float slant = max(abs(cosine), leastSlant);
  vec4 place = VCDCMatrix * position;
  float pixel = pixelVC * place.w;
  if (place.w > 0.0 && place.z > -place.w)
  {
    // Not behind the eye nor before the near plane.
    float towards = min(lift * pixel / slant, eyeVC.w == 0.0 ? lift * pixel / slant : 0.5 * length(position.xyz));
#ifdef INK_HATCHING
    // What lies just behind a silhouette would reach over it.
    towards = cosine < 0.0 && cullingCosine < 1.0 ? 0.0 : towards;
#endif
#ifdef INK_EDGES
    // It is to stay behind what faces the eye.
    towards = 0.0;
#endif
    vec4 lifted = VCDCMatrix * vec4(position.xyz + toEye * towards, 1.0);
    place.z = max(lifted.z / lifted.w, -1.0) * place.w;
  }

#if defined(INK_VOXELS) || defined(INK_EDGES)
  // Before the near plane there is nothing.
  place = found ? place : vec4(0.0, 0.0, -2.0, 1.0);
#endif

  ivec4 run = texelFetch(runs, int(drawn.z));
  vec4 stroke = texelFetch(strokes, run.z);
#ifdef INK_VOXELS
  stroke.y = whole;
#endif
  float along = point.w - stroke.x;
  float width = shape.w;
  width *= 1.0 - depthWidth * clamp((-position.z - distances.x) / (distances.y - distances.x), 0.0, 1.0);

#ifdef INK_HATCHING
  vec3 unitNormal = normal == vec3(0.0) ? normal : normalize(normal);
  float halfOfTone = 0.5 * toneWidth(position.xyz, unitNormal, toEye, abs(pixel), run, stroke.z, source);
  // What tapering takes away at the ends.
  width *= stroke.w == 0.0 && stroke.y > 0.0 ? halfOfTone / (1.0 - 0.5 * taper) : halfOfTone;
#else
  width *= halfWidth.x + halfWidth.y / abs(pixel);
#endif

  placeVSOutput = place;
  shapeVSOutput = vec4(width, along, stroke.w == 0.0 ? stroke.y : 0.0, 0.0);
  int row = int(imageSize.x);
  vec2 texel = vec2(float(gl_VertexID % row), float(gl_VertexID / row)) + 0.5;
  gl_Position = vec4(2.0 * texel / imageSize - 1.0, 0.0, 1.0);
  gl_PointSize = 1.0;
}
