// SPDX-License-Identifier: BSD-3-Clause
// The view, as InkViewUniforms sets it.
uniform mat4 MCVCMatrix;
uniform mat3 normalMatrix; // inverse transpose of MCVCMatrix
uniform mat4 VCDCMatrix;
uniform vec4 eyeVC;        // perspective: (0,0,0,1); parallel: the direction towards the viewer, 0
uniform vec2 viewportSize; // pixels
uniform float unitVC;      // view units per model unit
uniform float pixelVC;     // view units per pixel where clip w is 1
uniform bool backFaces;    // whether what faces away is seen
uniform vec2 depthRange;   // distances of the clipping planes from the eye, view units
uniform vec4 depthToClip;  // clip z = x * view z + y, clip w = z * view z + w

// Clip z and w of what has some view z.
vec2 clipDepth(float z)
{
  return depthToClip.xz * z + depthToClip.yw;
}
