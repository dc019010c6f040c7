//VTK::System::Dec

// Zhang et al. 2014, section 3: one oriented disc per point, drawn as a screen-aligned sprite that bounds
// the disc's exact projection. The fragment shaders find out where on the disc a pixel lies.
//
// Disc coordinates are (u, v), with u^2 + v^2 <= 1 on the disc. In clip space the disc's point (u, v) is
// center + u clipU + v clipV. Over center.w, and relative to the centre's pixel, it lies at p (in pixels) with
//   p (1 + dot(w, (u, v))) = disc (u, v),
// which inverts to a 2 x 2 matrix and one division. This holds for any camera.

in vec3 pointMC;        // relative to the data's centre, over the data's size
in vec4 normalRadiusMC; // unit normal; radius over the data's size, 0 for points that are not drawn

uniform mat4 MCVCMatrix;
uniform mat3 normalMatrix;   // inverse transpose of MCVCMatrix
uniform mat4 VCDCMatrix;
uniform vec4 eyeVC;          // perspective: (0,0,0,1); parallel: the direction towards the viewer, 0
uniform vec2 viewportSize;   // pixels
uniform float unitVC;        // view units per model unit
uniform float pixelVC;       // view units per pixel where clip w is 1
uniform float radiusScale;   // lambda for illumination splats, 1 for depth splats
uniform float minimumRadius; // pixels
uniform bool backFaces;      // whether discs that face away are drawn
uniform float minimumLight;  // f_i below which discs on the other side are left out
uniform float tolerance;     // of the depth test, as a fraction of the point's radius

// Whether to leave out discs that the depth splats hide.
uniform bool cullHidden;
uniform sampler2D surface; // see the depth splats' fragment shader

flat out vec2 centerVSOutput;    // the disc's centre in pixels
flat out vec4 toDiscVSOutput;    // 2 x 2 matrix from pixels to disc coordinates, before the division
flat out vec2 perspectiveVSOutput;
flat out vec3 positionVSOutput;  // the disc's centre and axes in view coordinates
flat out vec3 axisUVSOutput;
flat out vec3 axisVVSOutput;
flat out float lightVSOutput;    // f_i; negative on discs that face away
flat out float weightVSOutput;   // 1 / r_i^2, up to a factor common to all points
flat out float slopeVSOutput;    // tangent of the angle between the normal and the viewer
flat out vec2 toleranceVSOutput; // view units; for no slope, and by slope
flat out int idVSOutput;

// Where, besides in its centre, a disc is looked at to tell whether it is hidden.
const vec2 probes[4] = vec2[](vec2(0.8, 0.0), vec2(0.0, 0.8), vec2(-0.8, 0.0), vec2(0.0, -0.8));

// Beyond this slope the surface counts as seen edge-on.
const float maximumSlope = 10.0;

// Whether the surface that the depth splats show in a pixel is the disc's own.
bool shows(vec2 pixel, float depth)
{
  vec2 shown = texelFetch(surface, ivec2(clamp(pixel, vec2(0.0), viewportSize - 1.0)), 0).rg;
  return sign(shown.g) * lightVSOutput > minimumLight && abs(shown.r - depth) <=
    toleranceVSOutput.x + toleranceVSOutput.y * min(abs(shown.g) - 1.0, slopeVSOutput);
}

void main()
{
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // outside, for points that are left out
  gl_PointSize = 1.0;
  centerVSOutput = vec2(0.0);
  toDiscVSOutput = vec4(0.0);
  perspectiveVSOutput = vec2(0.0);
  positionVSOutput = vec3(0.0);
  axisUVSOutput = vec3(0.0);
  axisVVSOutput = vec3(0.0);
  lightVSOutput = 0.0;
  weightVSOutput = 0.0;
  slopeVSOutput = 0.0;
  toleranceVSOutput = vec2(0.0);
  idVSOutput = gl_VertexID;

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
  disc = (square + mat2(area)) / sqrt(square[0].x + square[1].y + 2.0 * area) * turn;

  // The box around the disc's projection, from the tangents to its conic; the part of it in the viewport.
  // Cutting it to the viewport keeps splats whose centre lies outside.
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

  lightVSOutput = light;
  slopeVSOutput = min(sqrt(1.0 - min(light * light, 1.0)) / max(abs(light), 1e-3), maximumSlope);
  toleranceVSOutput = tolerance * vec2(normalRadiusMC.w * unitVC, minimumRadius * pixelVC * center.w);

  if (cullHidden)
  {
    bool visible = shows(centerPixel, -positionVC.z);
    for (int i = 0; i < 4 && !visible; ++i)
    {
      vec2 probe = probes[i];
      float depth = -(positionVC.z + axisU.z * probe.x + axisV.z * probe.y);
      visible = shows(centerPixel + disc * probe / (1.0 + dot(w, probe)), depth);
    }
    if (!visible)
    {
      return;
    }
  }

  centerVSOutput = centerPixel;
  toDiscVSOutput = vec4(disc[1].y, -disc[0].y, -disc[1].x, disc[0].x) / determinant(disc);
  perspectiveVSOutput = w;
  positionVSOutput = positionVC.xyz;
  axisUVSOutput = axisU;
  axisVVSOutput = axisV;
  weightVSOutput = 1.0 / (radius * radius);

  gl_Position = vec4((low + high) / viewportSize - 1.0, 0.0, 1.0);
  // A little more than the box, against rounding.
  gl_PointSize = max(high.x - low.x, high.y - low.y) + 0.25;
}
