// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INK::Features

// The surface that hides marks as discs around its points, each a sprite that bounds its disc: only depth counts.
// Those that face the viewer are drawn first; with INK_BACK of the others those that are not hidden at their
// middle and at four positions around it, or are so large that much of them could lie elsewhere.

#include "InkClipping.glsl"
#include "InkViewUniforms.glsl"

in vec3 pointMC;
in vec3 normalMC; // of the disc's radius as length

uniform vec2 targetSize; // what is drawn into with its margin, pixels
#ifdef INK_BACK
uniform sampler2D facing; // depth of what faces the viewer
#endif

flat out vec4 centerVSOutput; // the center in pixels and its view z; that of the disc by pixels along x,
flat out vec4 discVSOutput;   // along y. The disc is where a x^2 + 2 b x y + c y^2 <= 1: a, b, c

// Smaller discs would slip between the pixels.
const float leastRadius = 0.75; // pixels

#ifdef INK_BACK
// Larger discs are drawn without a look at what hides them.
const float largestSkipped = 8.0; // pixels

// Whether in a pixel something is before a depth.
bool hides(vec2 pixel, float depth)
{
  return texelFetch(facing, ivec2(clamp(pixel, vec2(0.0), viewportSize - 1.0)), 0).r < depth;
}
#endif

void main()
{
  // Beyond the target, but within the viewport: software rasterizers take a slow way where anything is clipped.
  gl_Position = vec4(1.0 - INK_MARGIN / targetSize.x, 0.0, 0.0, 1.0);
  gl_PointSize = 1.0;
  centerVSOutput = vec4(0.0);
  discVSOutput = vec4(0.0);

  vec4 position = MCVCMatrix * vec4(pointMC, 1.0);
  vec4 center = VCDCMatrix * position;
  if (any(greaterThan(abs(center.xyz), center.www)) || clipDistance(position) < 0.0)
  {
    return;
  }
  vec3 normal = normalize(normalMatrix * normalMC);
  vec3 toEye = normalize(eyeVC.xyz - eyeVC.w * position.xyz);
  float facesEye = dot(normal, toEye);
#ifdef INK_BACK
  bool drawn = facesEye < 0.0;
#else
  bool drawn = facesEye > 0.0;
#endif
  if (!drawn)
  {
    return;
  }

  // Lines of sight, the same for all of a disc, meet its plane: what is b away in the viewer's plane, at
  // b - toEye (q . b), whose squared length is a form in b.
  float pixel = pixelVC * center.w;
  float radius = max(length(normalMC) * unitVC, leastRadius * pixel) / pixel;
  vec2 q = normal.xy / facesEye;
  vec3 form = vec3(1.0 - 2.0 * toEye.x * q.x + q.x * q.x, q.x * q.y - toEye.x * q.y - toEye.y * q.x,
    1.0 - 2.0 * toEye.y * q.y + q.y * q.y);
  float root = abs(toEye.z / facesEye); // of its determinant
  vec2 slope = -toEye.z * pixel * q;
  // Of the form's ellipse.
  vec2 extent = min(radius * sqrt(form.zx) / root, radius);
  vec2 centerPixel = (0.5 * center.xy / center.w + 0.5) * viewportSize;
#ifdef INK_BACK
  // Of the disc's nearest position.
  float z = min(position.z + dot(abs(slope), extent), -depthRange.x);
  vec2 clip = clipDepth(z);
  float depth = 0.5 * clip.x / clip.y + 0.5;
  vec2 aside = 0.8 * vec2(extent.x, 0.0);
  vec2 above = 0.8 * vec2(0.0, extent.y);
  if (max(extent.x, extent.y) < largestSkipped && hides(centerPixel, depth) && hides(centerPixel + aside, depth) &&
    hides(centerPixel - aside, depth) && hides(centerPixel + above, depth) && hides(centerPixel - above, depth))
  {
    return;
  }
#endif
  centerVSOutput = vec4(centerPixel, position.z, slope.x);
  discVSOutput = vec4(slope.y, form / (radius * radius));
  gl_Position = vec4(2.0 * centerPixel / targetSize - 1.0, 0.0, 1.0);
  gl_PointSize = 2.0 * max(extent.x, extent.y) + 1.0;
}
