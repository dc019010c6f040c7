// SPDX-License-Identifier: BSD-3-Clause
// Segments through voxels that lie on an edge in a volume (Lu et al. 2003, section 5.6).

uniform vec4 eyeMC;          // perspective: (eye, 1); parallel: the direction towards the viewer, 0; local frame
uniform vec2 valueBounds;
uniform float leastGradient; // magnitude
uniform float largestCosine; // of the angle between gradient and eye
uniform float segmentLength; // of the voxel's own

// Whether the voxel is on a silhouette: as SilhouetteCriteria::accept of Common/Curves/Contours/SilhouetteVoxels.h.
bool isSilhouette(float value, vec3 gradient, vec3 toEye)
{
  float magnitude = length(gradient);
  return value >= valueBounds.x && value <= valueBounds.y && magnitude >= leastGradient &&
    abs(dot(gradient, toEye)) <= largestCosine * magnitude * length(toEye);
}

// Moves the center of a voxel to an end (0 or 1) of its segment, along gradient x eye; false if it has none.
// voxel: position and value, then position and arc length; shape: gradient and half length, then gradient and width
bool findSegmentEnd(int end, inout vec4 voxel, inout vec4 shape, out float whole)
{
  float halfLength = segmentLength * shape.w;
  vec3 toEye = eyeMC.xyz - eyeMC.w * voxel.xyz;
  vec3 along = cross(shape.xyz, toEye);
  bool found = isSilhouette(voxel.w, shape.xyz, toEye) && along != vec3(0.0);
  vec3 way = found ? halfLength * normalize(along) : vec3(0.0);
  whole = 2.0 * halfLength;
  voxel = end == 0 ? vec4(voxel.xyz - way, 0.0) : vec4(voxel.xyz + way, whole);
  shape.w = 1.0;
  return found;
}
