//VTK::System::Dec

// Zhang et al. 2014, section 3: one oriented disc per point, drawn as a screen-aligned sprite that bounds
// the disc's exact projection. The fragment shaders find out where on the disc a pixel lies.
//
// Disc coordinates are (u, v), with u^2 + v^2 <= 1 on the disc. In clip space the disc's point (u, v) is
// center + u axisU + v axisV, so relative to the centre's pixel it lies at d (in pixels) with
//   d (dot(axisW, (u, v)) + w) = mat2(axisU.xy, axisV.xy) (u, v),
// which inverts to a 2 x 2 matrix and one division. This holds for any camera.

in vec3 pointMC;        // relative to the data's centre, over the data's size
in vec4 normalRadiusMC; // unit normal; radius over the data's size, 0 for points that are not drawn

uniform mat4 MCVCMatrix;
uniform mat3 normalMatrix;   // inverse transpose of MCVCMatrix
uniform mat4 VCDCMatrix;
uniform vec4 eyeVC;          // perspective: (0,0,0,1); parallel: the direction towards the viewer, 0
uniform vec2 viewportSize;   // pixels
uniform float pixelsPerUnit; // pixels that one model unit covers at w = 1
uniform float radiusScale;   // lambda for illumination splats, 1 for depth splats
uniform float minimumRadius; // pixels
uniform float lengthScale;   // view units per model unit
uniform float toleranceScale; // depth tolerance as a fraction of the point's radius

// Whether to drop discs that the depth image hides.
uniform bool cullHidden;
uniform sampler2D depthImage;
uniform vec2 depthRange;

flat out vec2 centerVSOutput;    // the disc's centre in pixels
flat out vec4 toDiscVSOutput;    // 2 x 2 matrix, pixels to disc coordinates before the perspective division
flat out vec2 perspectiveVSOutput;
flat out vec3 positionVSOutput;  // the disc's centre and axes in view coordinates
flat out vec3 axisUVSOutput;
flat out vec3 axisVVSOutput;
flat out float lightVSOutput;    // f_i
flat out float weightVSOutput;   // 1 / r_i^2, up to a factor common to all points
flat out float toleranceVSOutput; // view units
flat out int idVSOutput;

// Positions outside the clip volume, so that nothing is drawn.
void cull()
{
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  gl_PointSize = 1.0;
}

// Whether the surface that the depth image shows in a pixel is the disc's own.
bool shows(vec2 pixel, float depth, float tolerance)
{
  ivec2 texel = ivec2(clamp(pixel, vec2(0.0), viewportSize - 1.0));
  float stored = texelFetch(depthImage, texel, 0).r;
  return stored < 1.0 && abs(mix(depthRange.x, depthRange.y, stored) - depth) <= tolerance;
}

void main()
{
  centerVSOutput = vec2(0.0);
  toDiscVSOutput = vec4(0.0);
  perspectiveVSOutput = vec2(0.0);
  positionVSOutput = vec3(0.0);
  axisUVSOutput = vec3(0.0);
  axisVVSOutput = vec3(0.0);
  lightVSOutput = 0.0;
  weightVSOutput = 0.0;
  toleranceVSOutput = 0.0;
  idVSOutput = gl_VertexID;
  cull();

  float radius = normalRadiusMC.w;
  if (!(radius > 0.0))
  {
    return;
  }

  vec4 positionVC = MCVCMatrix * vec4(pointMC, 1.0);
  vec3 normalVC = normalize(normalMatrix * normalRadiusMC.xyz);
  vec3 toEye = normalize(eyeVC.xyz - eyeVC.w * positionVC.xyz);
  float light = dot(normalVC, toEye);
  vec4 center = VCDCMatrix * positionVC;
  if (light <= 0.0 || center.w <= 0.0)
  {
    return;
  }

  // Far away, discs smaller than a pixel would leave holes.
  float pixels = radius * pixelsPerUnit / center.w;
  float tolerance = toleranceScale * radius * max(1.0, minimumRadius / pixels) * lengthScale;
  radius *= radiusScale * max(1.0, minimumRadius / (radiusScale * pixels));

  // Axes of the disc: an orthonormal basis (Duff et al. 2017) scaled to the radius.
  vec3 n = normalRadiusMC.xyz;
  float side = n.z < 0.0 ? -1.0 : 1.0;
  float a = -1.0 / (side + n.z);
  float b = n.x * n.y * a;
  vec3 u = radius * vec3(1.0 + side * n.x * n.x * a, side * b, -side * n.x);
  vec3 v = radius * vec3(b, side + n.y * n.y * a, -n.y);
  vec3 axisU = mat3(MCVCMatrix) * u;
  vec3 axisV = mat3(MCVCMatrix) * v;

  vec4 clipU = VCDCMatrix * vec4(axisU, 0.0);
  vec4 clipV = VCDCMatrix * vec4(axisV, 0.0);
  vec2 centerNDC = center.xy / center.w;
  vec2 pixelU = 0.5 * viewportSize * (clipU.xy - centerNDC * clipU.w);
  vec2 pixelV = 0.5 * viewportSize * (clipV.xy - centerNDC * clipV.w);
  vec2 w = vec2(clipU.w, clipV.w);
  float area = pixelU.x * pixelV.y - pixelU.y * pixelV.x;
  if (area == 0.0)
  {
    return;
  }

  // The box around the disc's projection, from the tangents to its conic; the part of it in the viewport.
  vec2 centerPixel = (0.5 * centerNDC + 0.5) * viewportSize;
  vec2 low = vec2(0.0);
  vec2 high = viewportSize;
  float conic = dot(w, w) - center.w * center.w;
  if (conic < 0.0) // otherwise the disc reaches through the eye's plane
  {
    vec2 x = vec2(pixelU.x, pixelV.x);
    vec2 y = vec2(pixelU.y, pixelV.y);
    vec2 xw = vec2(dot(x, w), dot(y, w));
    vec2 middle = centerPixel + xw / conic;
    vec2 extent = sqrt(xw * xw - conic * vec2(dot(x, x), dot(y, y))) / -conic;
    low = max(low, middle - extent);
    high = min(high, middle + extent);
  }
  if (low.x >= high.x || low.y >= high.y)
  {
    return;
  }

  if (cullHidden)
  {
    // The centre and eight points on the rim.
    bool visible = shows(centerPixel, -positionVC.z, tolerance);
    for (int i = 0; i < 8 && !visible; ++i)
    {
      float angle = 0.785398163 * float(i);
      vec2 rim = 0.9 * vec2(cos(angle), sin(angle));
      vec2 pixel = (pixelU * rim.x + pixelV * rim.y) / (center.w + dot(w, rim));
      float depth = -(positionVC.z + axisU.z * rim.x + axisV.z * rim.y);
      visible = shows(centerPixel + pixel, depth, tolerance);
    }
    if (!visible)
    {
      return;
    }
  }

  centerVSOutput = centerPixel;
  toDiscVSOutput = center.w / area * vec4(pixelV.y, -pixelU.y, -pixelV.x, pixelU.x);
  perspectiveVSOutput = w / center.w;
  positionVSOutput = positionVC.xyz;
  axisUVSOutput = axisU;
  axisVVSOutput = axisV;
  lightVSOutput = light;
  weightVSOutput = 1.0 / (radius * radius);
  toleranceVSOutput = tolerance;

  gl_Position = vec4((low + high) / viewportSize - 1.0, 0.0, 1.0);
  gl_PointSize = max(high.x - low.x, high.y - low.y) + 0.25;
}
