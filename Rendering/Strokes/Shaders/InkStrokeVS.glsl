// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// A rectangle around each segment of a stroke, two triangles.

#include "InkStrokeSegment.glsl"

uniform usamplerBuffer drawnPoints; // source point, share of the way to the next * 2^32, run
uniform isamplerBuffer runs;        // first, last, stroke, flags
uniform samplerBuffer strokes;      // arc length at its begin, arc length, priority, whether closed

uniform int segmentStep; // 2 where each stroke has a single segment
uniform float density;
uniform bool miter;
uniform float miterLimit;

flat out int segmentVSOutput;
flat out ivec4 runVSOutput;
flat out ivec2 besideVSOutput; // how many segments before and after it may cover the same pixels

// Segments of a fraction of a pixel are more than that, but then hardly turn.
const int mostBeside = 12;

float lengthOf(int segment)
{
  Segment own;
  return findSegment(segment, own) ? distance(own.ends[0], own.ends[1]) : 0.0;
}

int countBeside(int segment, int step, ivec4 run, float reach)
{
  int count = 1;
  float between = 0.0;
  int index = segment;
  while (count < mostBeside)
  {
    index += step;
    if (index < run.x || index >= run.y)
    {
      if ((run.w & 1) == 0)
      {
        break;
      }
      index = index < run.x ? run.y - 1 : run.x;
    }
    between += lengthOf(index);
    if (between > reach)
    {
      break;
    }
    ++count;
  }
  return count;
}

void main()
{
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // outside
  int segment = gl_VertexID / 6 * segmentStep;
  int corner = gl_VertexID % 6;
  ivec4 run = texelFetch(runs, int(texelFetch(drawnPoints, segment).z));
  segmentVSOutput = segment;
  runVSOutput = run;
  besideVSOutput = ivec2(0);
  Segment own;
  if (segment >= run.y || texelFetch(strokes, run.z).z >= density || !findSegment(segment, own))
  {
    return;
  }
  float width = max(own.shapes[0].x, own.shapes[1].x);
  if (!(width > 0.0))
  {
    return;
  }
  besideVSOutput = ivec2(countBeside(segment, -1, run, 2.0 * width + 2.0), countBeside(segment, 1, run, 2.0 * width + 2.0));

  vec2 direction = own.ends[1] - own.ends[0];
  direction = direction == vec2(0.0) ? vec2(1.0, 0.0) : normalize(direction);
  // A pixel's own width in addition.
  float beside = width + 1.0;
  float beyond = (miter ? miterLimit * width : width) + 1.0;
  bool end = corner == 1 || corner == 2 || corner == 4;
  float side = corner == 2 || corner == 4 || corner == 5 ? 1.0 : -1.0;
  vec2 pixel = own.ends[end ? 1 : 0] + direction * (end ? beyond : -beyond) + vec2(-direction.y, direction.x) * side * beside;
  gl_Position = vec4(2.0 * pixel / viewportSize - 1.0, 0.0, 1.0);
}
