// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INK::Features

// The surface that hides marks as discs around its points, each a sprite that bounds its disc: only depth counts.

#include "InkClipping.glsl"
#include "InkViewUniforms.glsl"

in vec3 pointMC;
in vec3 normalMC; // of the disc's radius as length

flat out vec4 centerVSOutput; // the center in pixels, its view z, view units per pixel there
flat out vec4 discVSOutput;   // unit normal and radius in view units
flat out vec3 toEyeVSOutput;

// Smaller discs would slip between the pixels.
const float leastRadius = 0.75; // pixels

void main()
{
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // outside
  gl_PointSize = 1.0;
  centerVSOutput = vec4(0.0);
  discVSOutput = vec4(0.0);
  toEyeVSOutput = vec3(0.0);

  vec4 position = MCVCMatrix * vec4(pointMC, 1.0);
  vec4 center = VCDCMatrix * position;
  if (center.w <= 0.0 || clipDistance(position) < 0.0)
  {
    return;
  }
  float pixel = pixelVC * center.w;
  float radius = max(length(normalMC) * unitVC, leastRadius * pixel);
  centerVSOutput = vec4((0.5 * center.xy / center.w + 0.5) * viewportSize, position.z, pixel);
  discVSOutput = vec4(normalize(normalMatrix * normalMC), radius);
  toEyeVSOutput = normalize(eyeVC.xyz - eyeVC.w * position.xyz);
  gl_Position = center;
  gl_PointSize = 2.0 * radius / pixel + 1.0;
}
