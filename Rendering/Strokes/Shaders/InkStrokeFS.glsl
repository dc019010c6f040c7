// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INK::Features

// The part of a stroke that belongs to one of its segments: the pixels that no other segment beside it covers more.

#include "InkClipping.glsl"
#include "InkStrokeSegment.glsl"
#ifdef INK_IDS
#include "InkIds.glsl"
uniform usamplerBuffer pointIds;
#endif

#ifdef INK_TEXTURE
#include "InkStrokeTexture.glsl"
#endif

flat in int segmentVSOutput;
flat in ivec4 runVSOutput; // first, last, stroke, flags
flat in ivec2 besideVSOutput;

uniform usamplerBuffer drawnPoints; // source point, share of the way to the next * 2^32, run
uniform samplerBuffer strokes;      // arc length at its begin, arc length, priority, whether closed
#ifdef INK_COLORS
uniform samplerBuffer pointColors;
#endif
#ifdef INK_PLANES
uniform samplerBuffer sourcePoints; // position in the local frame, arc length
#endif
uniform vec3 inkColor;

uniform vec2 viewportOrigin; // pixels
uniform float actorOpacity;
uniform float hiddenOpacity;
uniform float leastCoverage;
#ifdef INK_MITER
uniform float miterLimit;
#endif
uniform bool butt;
#ifdef INK_DASHED
uniform bool dashed;
uniform bool hiddenDashed;
uniform vec2 dash; // lengths of a dash, and of it with a gap
#endif

#ifdef INK_OCCLUDED
uniform sampler2D occluder;
uniform float occluderScale;  // its pixels for one of the picture
uniform float occluderMargin; // its pixels
uniform float lift;           // pixels
#endif

//VTK::DepthPeeling::Dec

//VTK::Output::Dec

const int closedRun = 1;
const int cutBegin = 2;
const int cutEnd = 4;
const int hiddenRun = 8;

// The share of a pixel behind an edge: its signed distance from the pixel's center, and the edge's unit normal.
float behindEdge(float distance, vec2 normal)
{
  float larger = max(abs(normal.x), abs(normal.y));
  float smaller = min(abs(normal.x), abs(normal.y));
  float corner = 0.5 * (larger + smaller) - abs(distance);
  float share = corner <= 0.0 ? 0.0 : corner < smaller ? 0.5 * corner * corner / (larger * smaller)
                                                       : 0.5 - abs(distance) / larger;
  return distance > 0.0 ? 1.0 - share : share;
}

struct Nearest
{
  float inside; // how far in pixels a pixel lies within the stroke, negative outside
  float share;  // of the way along the segment
  float width;  // half, pixels
  vec2 away;    // from the nearest point
};

Nearest findNearest(Segment segment, vec2 pixel)
{
  Nearest nearest;
  vec2 way = segment.ends[1] - segment.ends[0];
  float square = dot(way, way);
  nearest.share = square > 0.0 ? clamp(dot(pixel - segment.ends[0], way) / square, 0.0, 1.0) : 0.0;
  // Exactly the ends, which are others', too.
  vec2 point = nearest.share == 0.0 ? segment.ends[0]
    : nearest.share == 1.0          ? segment.ends[1]
                                    : segment.ends[0] + nearest.share * way;
  nearest.width = widthAt(segment, nearest.share);
  nearest.away = pixel - point;
  nearest.inside = nearest.width - length(nearest.away);
  return nearest;
}

// The segment so many steps along the run; -1 if there is none.
int segmentBeside(int steps)
{
  int index = segmentVSOutput + steps;
  int count = runVSOutput.y - runVSOutput.x;
  bool before = index < runVSOutput.x;
  if (!before && index < runVSOutput.y)
  {
    return index;
  }
  // No steps go around a closed run more than once.
  return (runVSOutput.w & closedRun) == 0 ? -1 : before ? index + count : index - count;
}

// Whether a segment covers a pixel more than those beside it do, or as much and comes first.
bool coversMost(float inside, vec2 pixel)
{
  bool most = true;
  for (int step = -besideVSOutput.x; step <= besideVSOutput.y; ++step)
  {
    int index = segmentBeside(step);
    Segment other;
    if (index >= 0 && index != segmentVSOutput && findSegment(index, other))
    {
      float others = findNearest(other, pixel).inside;
      most = most && (others < inside || (others == inside && index > segmentVSOutput));
    }
  }
  return most;
}

// How much of a pixel a stroke covers across its direction, which ends in a corner or not.
float coverageAcross(Segment own, Nearest nearest, vec2 pixel, vec2 direction)
{
  vec2 across = vec2(-direction.y, direction.x);
  float distance = length(nearest.away);
  vec2 normal = distance > 1e-4 ? nearest.away / distance : across;
  bool begins = nearest.share == 0.0;
  int beyond = begins ? segmentBeside(-1) : nearest.share == 1.0 ? segmentBeside(1) : segmentVSOutput;
  bool cut = (runVSOutput.w & (begins ? cutBegin : cutEnd)) != 0;
  if (beyond < 0 && (butt || cut))
  {
    distance = abs(dot(nearest.away, across));
    normal = across;
  }
#ifdef INK_MITER
  Segment other;
  if (beyond >= 0 && beyond != segmentVSOutput && findSegment(beyond, other) &&
    other.ends[0] != other.ends[1])
  {
    vec2 turned = normalize(other.ends[1] - other.ends[0]);
    // The corner is 1 / cos(half the turn) widths away.
    if (0.5 * (1.0 + dot(direction, turned)) * miterLimit * miterLimit >= 1.0)
    {
      vec2 acrossOther = vec2(-turned.y, turned.x);
      vec2 distances = abs(vec2(dot(nearest.away, across), dot(nearest.away, acrossOther)));
      distance = max(distances.x, distances.y);
      normal = distances.x > distances.y ? across : acrossOther;
    }
  }
#endif
  return behindEdge(nearest.width - distance, normal) + behindEdge(nearest.width + distance, normal) - 1.0;
}

// The same along it, where the stroke begins or ends without a round cap.
float coverageAlong(Segment own, vec2 pixel, vec2 direction)
{
  float coverage = 1.0;
  if (segmentBeside(-1) < 0 && (butt || (runVSOutput.w & cutBegin) != 0))
  {
    coverage *= behindEdge(dot(pixel - own.ends[0], direction), direction);
  }
  if (segmentBeside(1) < 0 && (butt || (runVSOutput.w & cutEnd) != 0))
  {
    coverage *= behindEdge(dot(own.ends[1] - pixel, direction), direction);
  }
  return coverage;
}

// Pixels on the picture for each unit of a segment's arc length.
float pixelsPerArc(Segment own)
{
  float arc = abs(own.shapes[1].y - own.shapes[0].y);
  return arc > 0.0 ? distance(own.ends[0], own.ends[1]) / arc : 0.0;
}

#ifdef INK_DASHED
// How much of a pixel lies in a dash, at an arc length from the stroke's begin. In a closed stroke there are whole
// dashes with their gaps.
float coverageOfDash(Segment own, float arcLength, vec2 direction)
{
  vec4 stroke = texelFetch(strokes, runVSOutput.z);
  vec2 fitted = dash * (stroke.w == 0.0 ? 1.0 : stroke.y / (dash.y * max(round(stroke.y / dash.y), 1.0)));
  float scale = pixelsPerArc(own);
  if (stroke.w == 0.0 && scale > 0.0)
  {
    // At an end, and beyond it in a cap, as much as within: a dash that begins with the stroke has a whole cap.
    float pixel = min(0.71 / scale, 0.5 * stroke.y);
    arcLength = clamp(arcLength, pixel, stroke.y - pixel);
  }
  float phase = mod(stroke.x + arcLength, fitted.y);
  phase -= phase > 0.5 * (fitted.x + fitted.y) ? fitted.y : 0.0;
  float sharp = behindEdge(phase * scale, direction) + behindEdge((fitted.x - phase) * scale, direction) - 1.0;
  // Where a period is no more than a pixel, its mean.
  return mix(fitted.x / fitted.y, sharp, clamp(fitted.y * scale - 1.0, 0.0, 1.0));
}
#endif

#ifdef INK_COLORS
vec4 colorOf(int point)
{
  uvec4 drawn = texelFetch(drawnPoints, point);
  vec4 color = texelFetch(pointColors, int(drawn.x));
  return drawn.y > 0u ? mix(color, texelFetch(pointColors, int(drawn.x) + 1), float(drawn.y) / 4294967296.0) : color;
}
#endif

#ifdef INK_PLANES
vec4 positionOf(int point)
{
  uvec4 drawn = texelFetch(drawnPoints, point);
  vec3 position = texelFetch(sourcePoints, int(drawn.x)).xyz;
  if (drawn.y > 0u)
  {
    position = mix(position, texelFetch(sourcePoints, int(drawn.x) + 1).xyz, float(drawn.y) / 4294967296.0);
  }
  return MCVCMatrix * vec4(position, 1.0);
}
#endif

#ifdef INK_OCCLUDED
#ifdef INK_HIDDEN
// The share of a pixel that the surface leaves to a stroke of some depth.
float visibleShare(vec2 pixel, float depth)
{
  ivec2 last = textureSize(occluder, 0) - 1;
  float visible = 0.0;
  for (int quarter = 0; quarter < 4; ++quarter)
  {
    vec2 at = pixel + 0.5 * vec2(float(quarter & 1), float(quarter >> 1)) - 0.25;
    ivec2 texel = clamp(ivec2(at * occluderScale + occluderMargin), ivec2(0), last);
    visible += depth <= texelFetch(occluder, texel, 0).r ? 0.25 : 0.0;
  }
  return visible;
}
#endif

// The depth of the surface around a pixel, lifted: the stroke lies on it, where it is nearer.
float surfaceDepth(vec2 pixel)
{
  ivec2 middle = ivec2(pixel * occluderScale + occluderMargin);
  ivec2 last = textureSize(occluder, 0) - 1;
  float depth = 1.0;
  for (int y = -1; y <= 1; ++y)
  {
    for (int x = -1; x <= 1; ++x)
    {
      depth = min(depth, texelFetch(occluder, clamp(middle + ivec2(x, y), ivec2(0), last), 0).r);
    }
  }
  float ndc = 2.0 * depth - 1.0;
  float z = (depthToClip.y - ndc * depthToClip.w) / (ndc * depthToClip.z - depthToClip.x);
  z += lift * pixelVC * clipDepth(z).y;
  vec2 lifted = clipDepth(z);
  return max(lifted.x / lifted.y, -1.0);
}
#endif

// What the stroke makes of this pixel; false where it is another segment's, or nothing.
bool findInk(out vec4 ink, out float depth)
{
  ink = vec4(0.0);
  depth = 0.0;
  vec2 pixel = gl_FragCoord.xy - viewportOrigin;
  Segment own;
  if (!findSegment(segmentVSOutput, own))
  {
    return false;
  }
  Nearest nearest = findNearest(own, pixel);
  vec2 way = own.ends[1] - own.ends[0];
  vec2 direction = way == vec2(0.0) ? vec2(1.0, 0.0) : normalize(way);
  float share = shareInSpace(own, nearest.share);
  vec4 shape = mix(own.shapes[0], own.shapes[1], share);

  float coverage = coverageAcross(own, nearest, pixel, direction) * coverageAlong(own, pixel, direction);
  bool hidden = (runVSOutput.w & hiddenRun) != 0;
#ifdef INK_DASHED
  if (dashed || (hidden && hiddenDashed))
  {
    coverage *= coverageOfDash(own, shape.y, direction);
  }
#endif
  float opacity = actorOpacity * (hidden ? hiddenOpacity : 1.0);
  vec3 color = inkColor;
#ifdef INK_COLORS
  vec4 colored = mix(colorOf(segmentVSOutput), colorOf(segmentVSOutput + 1), mix(own.cut.x, own.cut.y, share));
  color = colored.rgb;
  opacity *= colored.a;
#endif
#ifdef INK_TEXTURE
  vec4 stroke = texelFetch(strokes, runVSOutput.z);
  float beyond = nearest.share == 0.0 && segmentBeside(-1) < 0 ? min(dot(nearest.away, direction), 0.0)
    : nearest.share == 1.0 && segmentBeside(1) < 0             ? max(dot(nearest.away, direction), 0.0)
                                                               : 0.0;
  vec4 texel = strokeTexel(shape.y, stroke.w == 0.0 ? 0.0 : stroke.y, pixelsPerArc(own), max(nearest.width, 1e-3),
    direction, nearest.away, beyond);
#ifdef INK_TINTED
  color = texel.rgb;
  coverage *= texel.a;
#else
  coverage *= texel.r;
#endif
#endif
  depth = mix(own.places[0].z / own.places[0].w, own.places[1].z / own.places[1].w, nearest.share);
#ifdef INK_PLANES
  vec4 position = mix(positionOf(segmentVSOutput), positionOf(segmentVSOutput + 1), mix(own.cut.x, own.cut.y, share));
  coverage = clipDistance(position) < 0.0 ? 0.0 : coverage;
#endif
#ifdef INK_HIDDEN
  coverage *= visibleShare(pixel, 0.5 * depth + 0.5);
#endif
  if (!(coverage * opacity > leastCoverage) || depth > 1.0 || !coversMost(nearest.inside, pixel))
  {
    return false;
  }
#ifdef INK_OCCLUDED
  depth = min(depth, surfaceDepth(pixel));
#endif
  depth = 0.5 * depth + 0.5;
#ifdef INK_IDS
  uvec4 drawn = texelFetch(drawnPoints, segmentVSOutput + (share > 0.5 ? 1 : 0));
  ink = idColor(int(texelFetch(pointIds, int(drawn.x) + (drawn.y > 2147483648u ? 1 : 0)).r));
#else
  ink = vec4(color, coverage * opacity);
#endif
  return true;
}

// Render passes add variables of their own.
void main()
{
  vec4 inkOfStroke;
  float depthOfStroke;
  if (!findInk(inkOfStroke, depthOfStroke))
  {
    discard;
  }
  gl_FragDepth = depthOfStroke;

  //VTK::DepthPeeling::PreColor

  gl_FragData[0] = inkOfStroke;

  //VTK::DepthPeeling::Impl
}
