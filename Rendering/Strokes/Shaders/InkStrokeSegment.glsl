// SPDX-License-Identifier: BSD-3-Clause
#include "InkViewUniforms.glsl"

// Segments of strokes on the picture, by the index of their first point.

uniform sampler2D pointPositions; // clip coordinates
uniform sampler2D pointShapes; // half width in pixels, arc length, the stroke's length if it is open
uniform float taper;           // share of a stroke's length

struct Segment
{
  vec4 places[2]; // clip coordinates, cut at the near plane
  vec4 shapes[2];
  vec2 ends[2];   // pixels
  vec2 cut;       // the shares of the whole segment that are left
};

// The width of the images, 2 to this: divisions of integers take long without a graphics card.
const int rowBits = 11;

vec4 pointTexel(sampler2D image, int point)
{
  return texelFetch(image, ivec2(point & ((1 << rowBits) - 1), point >> rowBits), 0);
}

vec2 pixelOf(vec4 place)
{
  return (0.5 * place.xy / place.w + 0.5) * viewportSize;
}

// False if nothing of it lies behind the near plane.
bool findSegment(int first, out Segment segment)
{
  vec4 a = pointTexel(pointPositions, first);
  vec4 b = pointTexel(pointPositions, first + 1);
  vec4 shapeA = pointTexel(pointShapes, first);
  vec4 shapeB = pointTexel(pointShapes, first + 1);
  float before = a.z + a.w;
  float after = b.z + b.w;
  bool seen = before >= 0.0 || after >= 0.0;
  vec2 cut = vec2(before < 0.0 ? before / (before - after) : 0.0, after < 0.0 ? before / (before - after) : 1.0);
  segment.cut = cut;
  segment.places[0] = cut.x > 0.0 ? mix(a, b, cut.x) : a;
  segment.places[1] = cut.y < 1.0 ? mix(a, b, cut.y) : b;
  // Points behind the eye have no width.
  segment.shapes[0] = cut.x > 0.0 ? vec4(shapeB.x, mix(shapeA.yzw, shapeB.yzw, cut.x)) : shapeA;
  segment.shapes[1] = cut.y < 1.0 ? vec4(shapeA.x, mix(shapeA.yzw, shapeB.yzw, cut.y)) : shapeB;
  segment.ends[0] = pixelOf(segment.places[0]);
  segment.ends[1] = pixelOf(segment.places[1]);
  return seen && segment.places[0].w > 0.0 && segment.places[1].w > 0.0;
}

// Even steps on the picture are uneven ones in space.
float shareInSpace(Segment segment, float share)
{
  vec2 w = vec2(segment.places[0].w, segment.places[1].w);
  return share * w.x / (w.y + share * (w.x - w.y));
}

// Half the width of a stroke at a share of the way along a segment on the picture, pixels.
float widthAt(Segment segment, float share)
{
  float width = mix(segment.shapes[0].x, segment.shapes[1].x, share);
  float whole = segment.shapes[0].z;
  if (taper > 0.0 && whole > 0.0)
  {
    float along = mix(segment.shapes[0].y, segment.shapes[1].y, shareInSpace(segment, share));
    width *= clamp(2.0 * min(along, whole - along) / (taper * whole), 0.0, 1.0);
  }
  return width;
}
