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
// Of strokes that turn by less nearby, only the next segments may cover the same pixels.
const float leastCosine = 0.5;
// Pixels.
const float leastBeyond = 0.5;

// How many segments on one side of a segment may cover the same pixels, those within `reach` of it, and how far a pixel
// that none of them covers more may lie beyond its end; pixels, the latter `margin` where no segment follows.
int countBeside(int segment, Segment own, vec2 direction, int step, ivec4 run, float reach, float margin, out float beyond)
{
  int count = 0;
  int most = min(mostBeside, run.y - run.x - 1);
  float between = 0.0;
  bool turns = false;
  int index = segment;
  beyond = margin;
  while (count < most && between <= reach)
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
    Segment other;
    bool seen = findSegment(index, other);
    vec2 way = seen ? other.ends[1] - other.ends[0] : vec2(0.0);
    float size = length(way);
    float cosine = size > 0.0 ? dot(way, direction) / size : -1.0;
    if (count == 0 && cosine > 0.0)
    {
      // Where it turns, and where it becomes wider: at half a width w beside a straight stroke that narrows by a slope s
      // the wider segment covers more up to 2 s w / (1 - s^2) beyond its end.
      float slope = max(abs(widthAt(other, 1.0) - widthAt(other, 0.0)) / size,
        abs(widthAt(own, 1.0) - widthAt(own, 0.0)) / max(distance(own.ends[0], own.ends[1]), 1e-6));
      float narrowing = 2.0 * slope / max(1.0 - slope * slope, 1e-3);
      beyond = min(margin * (sqrt(max(1.0 - cosine * cosine, 0.0)) + narrowing) + leastBeyond, margin);
    }
    turns = turns || cosine < leastCosine;
    between += size;
    ++count;
  }
  return turns ? count : min(count, 1);
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
  vec2 direction = own.ends[1] - own.ends[0];
  bool isPoint = direction == vec2(0.0);
  direction = isPoint ? vec2(1.0, 0.0) : normalize(direction);
  // A pixel's own width in addition.
  float beside = width + 1.0;
  float margin = (miter ? miterLimit * width : width) + 1.0;
  float reach = 2.0 * width + 2.0;
  vec2 beyond;
  besideVSOutput = ivec2(countBeside(segment, own, direction, -1, run, reach, margin, beyond.x),
    countBeside(segment, own, direction, 1, run, reach, margin, beyond.y));
  beyond = isPoint ? vec2(margin) : beyond;
  bool end = corner == 1 || corner == 2 || corner == 4;
  float side = corner == 2 || corner == 4 || corner == 5 ? 1.0 : -1.0;
  vec2 pixel = own.ends[end ? 1 : 0] + direction * (end ? beyond.y : -beyond.x) + vec2(-direction.y, direction.x) * side * beside;
  gl_Position = vec4(2.0 * pixel / viewportSize - 1.0, 0.0, 1.0);
}
