// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

//INK::Features

// Zhang et al. 2014, section 3: one oriented disc per point, drawn as a screen-aligned sprite that bounds
// the disc's exact projection. The fragment shaders find out where on the disc a pixel lies.
//
// Disc coordinates are (u, v), with u^2 + v^2 <= 1 on the disc. In clip space the disc's point (u, v) is
// center + u clipU + v clipV. Over center.w, and relative to the center's pixel, it lies at p (in pixels) with
//   p (1 + dot(w, (u, v))) = disc (u, v),
// which inverts to a 2 x 2 matrix and one division. This holds for any camera.

in vec3 pointMC;        // relative to the data's center, over the data's size
in vec4 normalRadiusMC; // unit normal; radius over the data's size, 0 for points that are not drawn
#ifdef INK_EDGES
in vec3 firstEdgeMC;    // to the nearest position on a sharp edge, and to the nearest in another direction; 0: none
in vec3 secondEdgeMC;
#endif
#ifdef INK_COLORS
in vec4 colorMC;
#endif
#ifdef INK_SOURCES
in vec2 sourceId; // the point's id, where that is not its number here: its lower 12 bits, and the others
#endif

#include "InkViewUniforms.glsl"

uniform vec2 targetSize;     // what is drawn into, in the viewport's pixels
uniform float texel;         // its texels' side in the viewport's pixels
uniform float radiusScale;   // lambda for illumination splats, 1 for depth splats
uniform float minimumRadius; // pixels
uniform float tolerance;     // of the depth test, as a fraction of the point's radius
uniform float slack;         // the same by slope, in pixels
uniform float minimumLight;  // f_i below which discs on the other side are left out

#if defined INK_LIGHT || defined INK_BACK
uniform sampler2D surface;     // that the depth splats show, see their fragment shader
uniform vec2 nearness;         // the part of the tolerance that holds in a disc's middle and at its rim
uniform int probeCount;        // where, besides in its center, a disc is tested for being hidden;
                               // negative: not at all
#endif
#ifdef INK_LIGHT
uniform float referenceRadius; // where the weight is 1
uniform float largestWeight;
#ifdef INK_COARSE
uniform vec2 falloff;          // 1 / (2 sigma^2) of the narrow and of the wide Gaussian
#endif
uniform vec2 widths;           // pixels: the least and the greatest narrower radius of the splats to draw
#endif

// What the fragment shaders need, in few varyings: each costs time for each point.
flat out vec4 toDiscVSOutput; // 2 x 2 matrix from pixels to disc coordinates, before the division
flat out vec4 centerVSOutput; // the disc's center in pixels; w, see above
#ifdef INK_EDGES
flat out vec3 firstEdgeVSOutput;  // the direction to where the disc ends, and how far away that is, in pixels
flat out vec3 secondEdgeVSOutput;
#endif
#ifdef INK_PLANES
flat out vec3 positionVSOutput; // the disc's center and axes in view coordinates
flat out vec3 axisUVSOutput;
flat out vec3 axisVVSOutput;
#endif
flat out vec4 discVSOutput;   // view z of the disc's center and of its two axes; f_i, negative on discs that face away
#if defined INK_LIGHT
flat out vec4 splatVSOutput;  // 1 / r_i^2, up to a factor common to all; slope; tolerances, see below
#ifdef INK_COARSE
flat out vec4 gaussiansVSOutput; // falloffs and gains of both
#endif
#elif defined INK_PEEL
flat out vec3 splatVSOutput;  // slope; tolerances
#elif defined INK_ID
flat out float splatVSOutput; // tolerance
flat out int idVSOutput;
#else
flat out float splatVSOutput; // slope
#endif
#ifdef INK_COLORS
flat out vec4 colorVSOutput;
#endif

// Beyond this slope, the tangent of the angle between normal and viewer, the surface counts as edge-on.
const float maximumSlope = 10.0;

#if defined INK_LIGHT || defined INK_BACK
const vec2 probes[4] = vec2[](vec2(0.8, 0.0), vec2(0.0, 0.8), vec2(-0.8, 0.0), vec2(0.0, -0.8));

// Whether in a pixel the surface is the disc's own, or with INK_BACK, lies behind it. What is outside the
// picture cannot be told.
bool shows(vec2 pixel, float depth, float light, float slope, vec2 tolerances)
{
  if (any(lessThan(pixel, vec2(0.0))) || any(greaterThanEqual(pixel, viewportSize)))
  {
    return true;
  }
  vec2 shown = texelFetch(surface, ivec2(pixel), 0).rg;
#ifdef INK_BACK
  return shown.r >= depth;
#else
  float both = min(abs(shown.g) - 1.0, slope);
  return sign(shown.g) * light > minimumLight &&
    abs(shown.r - depth) <= tolerances.x * min(nearness.x * length(vec2(1.0, both)), 1.0) + tolerances.y * both;
#endif
}
#endif

#ifdef INK_COARSE
// Of a Gaussian less its value at the rim over the disc, up to a factor.
vec2 sumOver(vec2 falloffs)
{
  vec2 rim = exp(-falloffs);
  return (1.0 - rim) / falloffs - rim;
}
#endif

#ifdef INK_EDGES
// Pixels by which discs reach over an edge, so that none is left between those of its two sides.
const float overlap = 0.5;

vec3 findEdge(vec3 edge, vec2 centerPixel)
{
  const vec3 none = vec3(0.0, 0.0, 1e9);
  // In the disc's plane, so that a disc that is seen edge-on is on the right side of the edge.
  edge -= dot(edge, normalRadiusMC.xyz) * normalRadiusMC.xyz;
  vec4 on = VCDCMatrix * (MCVCMatrix * vec4(pointMC + edge, 1.0));
  vec4 along = VCDCMatrix * (MCVCMatrix * vec4(pointMC + edge + cross(normalRadiusMC.xyz, edge), 1.0));
  if (edge == vec3(0.0) || on.w <= 0.0 || along.w <= 0.0)
  {
    return none;
  }
  vec2 onPixel = (0.5 * on.xy / on.w + 0.5) * viewportSize;
  vec2 direction = (0.5 * along.xy / along.w + 0.5) * viewportSize - onPixel;
  if (length(direction) < 1e-4)
  {
    return none;
  }
  vec2 across = normalize(vec2(direction.y, -direction.x));
  float distance = dot(across, onPixel - centerPixel);
  across *= distance < 0.0 ? -1.0 : 1.0;
  return vec3(across, abs(distance) + overlap);
}
#endif

void main()
{
  // For points that are left out: beyond the target, but within the viewport if that is wider, because
  // software rasterizers take a slow way where anything is clipped.
#ifdef INK_MARGIN
  gl_Position = vec4(1.0 - INK_MARGIN * texel / targetSize.x, 0.0, 0.0, 1.0);
#else
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
#endif
  gl_PointSize = 1.0;
  toDiscVSOutput = vec4(0.0);
  centerVSOutput = vec4(0.0);
  discVSOutput = vec4(0.0);
#ifdef INK_EDGES
  firstEdgeVSOutput = vec3(0.0);
  secondEdgeVSOutput = vec3(0.0);
#endif
#ifdef INK_PLANES
  positionVSOutput = vec3(0.0);
  axisUVSOutput = vec3(0.0);
  axisVVSOutput = vec3(0.0);
#endif
#if defined INK_LIGHT
  splatVSOutput = vec4(0.0);
#ifdef INK_COARSE
  gaussiansVSOutput = vec4(0.0);
#endif
#elif defined INK_PEEL
  splatVSOutput = vec3(0.0);
#else
  splatVSOutput = 0.0;
#endif
#if defined INK_SOURCES
  idVSOutput = int(sourceId.x) | (int(sourceId.y) << 12);
#elif defined INK_ID
  idVSOutput = gl_VertexID;
#endif
#ifdef INK_COLORS
  colorVSOutput = colorMC;
#endif

  float radius = normalRadiusMC.w * radiusScale;
  if (!(radius > 0.0))
  {
    return;
  }

  vec4 positionVC = MCVCMatrix * vec4(pointMC, 1.0);
  vec3 normalVC = normalize(normalMatrix * normalRadiusMC.xyz);
  float light = dot(normalVC, normalize(eyeVC.xyz - eyeVC.w * positionVC.xyz));
  vec4 center = VCDCMatrix * positionVC;
  if ((light <= minimumLight && !backFaces) || center.w <= 0.0)
  {
    return;
  }
#ifdef INK_BACK
  if (light > 0.0)
  {
    return;
  }
#endif

  // Axes of the disc: an orthonormal basis (Duff et al. 2017) scaled to the radius.
  vec3 n = normalRadiusMC.xyz;
  float s = n.z < 0.0 ? -1.0 : 1.0;
  float a = -1.0 / (s + n.z);
  float b = n.x * n.y * a;
  vec3 axisU = mat3(MCVCMatrix) * (radius * vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x));
  vec3 axisV = mat3(MCVCMatrix) * (radius * vec3(b, s + n.y * n.y * a, -n.y));

  vec4 clipU = VCDCMatrix * vec4(axisU, 0.0) / center.w;
  vec4 clipV = VCDCMatrix * vec4(axisV, 0.0) / center.w;
  vec2 w = vec2(clipU.w, clipV.w);
  vec2 centerNDC = center.xy / center.w;
  mat2 disc = mat2(0.5 * viewportSize * (clipU.xy - centerNDC * clipU.w),
    0.5 * viewportSize * (clipV.xy - centerNDC * clipV.w));

  // A disc that is far away or seen edge-on would slip between the pixels: its projection grows by
  // minimumRadius in all directions, as in EWA splatting (Zwicker et al. 2001). With the polar decomposition
  // disc = sqrt(disc disc^T) turn, the grown one is sqrt(disc disc^T + minimumRadius^2) turn.
  float handed = determinant(disc) < 0.0 ? -1.0 : 1.0;
  vec2 turnU = vec2(disc[0].x + handed * disc[1].y, disc[0].y - handed * disc[1].x);
  if (turnU == vec2(0.0))
  {
    return;
  }
  turnU = normalize(turnU);
  mat2 turn = mat2(turnU, handed * vec2(-turnU.y, turnU.x));
  mat2 square = disc * transpose(disc) + mat2(minimumRadius * minimumRadius);
  float area = sqrt(determinant(square));
#ifdef INK_LIGHT
  // The ellipse's narrower radius is the root of the square's smaller eigenvalue. Splats seen from the side
  // count as small: near contours the surface changes within few pixels.
  float middleWidth = 0.5 * (square[0].x + square[1].y);
  float spread = sqrt(max(middleWidth * middleWidth - area * area, 0.0));
  float width = sqrt(max(middleWidth - spread, 0.0));
  width = width * width < 0.1 * (middleWidth + spread) ? 0.0 : width;
  if (width < widths.x || width >= widths.y)
  {
    return;
  }
#endif
  disc = (square + mat2(area)) / sqrt(square[0].x + square[1].y + 2.0 * area) * turn;

  // The box around the disc's projection, from the tangents to its conic; the part of it in the viewport.
  // Cutting it to the viewport keeps splats whose center lies outside.
  vec2 centerPixel = (0.5 * centerNDC + 0.5) * viewportSize;
  vec2 low = vec2(0.0);
  vec2 high = viewportSize;
  float conic = dot(w, w) - 1.0;
  if (conic < 0.0) // otherwise the disc reaches through the eye's plane
  {
    vec2 discW = disc * w;
    vec2 length2 = disc[0] * disc[0] + disc[1] * disc[1];
    vec2 middle = centerPixel + discW / conic;
    vec2 extent = sqrt(discW * discW - conic * length2) / -conic;
    low = max(low, middle - extent);
    high = min(high, middle + extent);
  }
  if (low.x >= high.x || low.y >= high.y)
  {
    return;
  }

  float slope = min(sqrt(1.0 - min(light * light, 1.0)) / max(abs(light), 1e-3), maximumSlope);
  // In view units, for no slope and by slope.
  vec2 tolerances = vec2(tolerance * normalRadiusMC.w * unitVC, slack * pixelVC * center.w);

#if defined INK_LIGHT || defined INK_BACK
  bool visible = probeCount < 0 || shows(centerPixel, -positionVC.z, light, slope, tolerances);
  for (int i = 0; i < probeCount && !visible; ++i)
  {
    vec2 probe = probes[i];
    float depth = -(positionVC.z + axisU.z * probe.x + axisV.z * probe.y);
    visible = shows(centerPixel + disc * probe / (1.0 + dot(w, probe)), depth, light, slope, tolerances);
  }
  if (!visible)
  {
    return;
  }
#endif

#if defined INK_LIGHT
  float weight = referenceRadius / radius;
  splatVSOutput = vec4(min(weight * weight, largestWeight), slope, tolerances);
#ifdef INK_COARSE
  // Going from texels to pixels blurs by a variance of a sixth of a texel's square. By that, in the mean of a
  // disc's two directions, the Gaussians are narrower, and higher, so that each splat weighs as much.
  vec2 left = 1.0 - texel * texel * middleWidth / (3.0 * area * area) * falloff;
  gaussiansVSOutput = vec4(falloff / left, sumOver(falloff) / sumOver(falloff / left));
#endif
#elif defined INK_PEEL
  splatVSOutput = vec3(slope, tolerances);
#elif defined INK_ID
  splatVSOutput = tolerances.x;
#else
  splatVSOutput = slope;
#endif

  centerVSOutput = vec4(centerPixel, w);
  toDiscVSOutput = vec4(disc[1].y, -disc[0].y, -disc[1].x, disc[0].x) / determinant(disc);
  discVSOutput = vec4(positionVC.z, axisU.z, axisV.z, light);
#ifdef INK_EDGES
  firstEdgeVSOutput = findEdge(firstEdgeMC, centerPixel);
#ifdef INK_LIGHT
  // Where a surface ends at an edge, what faces away behind it is no contour.
  if (light <= 0.0 && firstEdgeVSOutput.z < minimumRadius)
  {
    return;
  }
#endif
  secondEdgeVSOutput = findEdge(secondEdgeMC, centerPixel);
#endif
#ifdef INK_PLANES
  positionVSOutput = positionVC.xyz;
  axisUVSOutput = axisU;
  axisVVSOutput = axisV;
#endif

  gl_Position = vec4((low + high) / targetSize - 1.0, 0.0, 1.0);
  // A little more than the box, against rounding.
  gl_PointSize = max(high.x - low.x, high.y - low.y) / texel + 0.25;
}
