// SPDX-License-Identifier: BSD-3-Clause
// Edges of polygons that face away from the eye (Raskar and Cohen 1999, as Lu et al. 2003, section 5.6): where they
// reach over those that face it, they are the silhouette.

uniform vec4 eyeMC; // perspective: (eye, 1); parallel: the direction towards the viewer, 0; local frame

// An edge's first point has the normal of one polygon, its last point that of the other one. Takes the normal of that
// which faces away more; false if none does.
bool findBackNormal(int source, inout vec3 normal)
{
  int first = source - source % 2;
  vec3 toEye = eyeMC.xyz - eyeMC.w * texelFetch(sourcePoints, first).xyz;
  vec3 one = texelFetch(sourceShapes, first).xyz;
  vec3 other = texelFetch(sourceShapes, first + 1).xyz;
  normal = dot(one, toEye) < dot(other, toEye) ? one : other;
  return dot(normal, toEye) < 0.0;
}
