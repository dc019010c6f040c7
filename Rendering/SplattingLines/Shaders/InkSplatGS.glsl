// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

//INK::Features

// Quads in place of point sprites, where a splat may be larger than the largest point of this OpenGL.

layout(points) in;
layout(triangle_strip, max_vertices = 4) out;

uniform vec2 targetSize;
uniform float texel;

flat in vec4 toDiscVSOutput[];
flat in vec4 centerVSOutput[];
flat in vec4 discVSOutput[];
flat out vec4 toDiscGSOutput;
flat out vec4 centerGSOutput;
flat out vec4 discGSOutput;
#ifdef INK_EDGES
flat in vec3 firstEdgeVSOutput[];
flat in vec3 secondEdgeVSOutput[];
flat out vec3 firstEdgeGSOutput;
flat out vec3 secondEdgeGSOutput;
#endif
#ifdef INK_PLANES
flat in vec3 positionVSOutput[];
flat in vec3 axisUVSOutput[];
flat in vec3 axisVVSOutput[];
flat out vec3 positionGSOutput;
flat out vec3 axisUGSOutput;
flat out vec3 axisVGSOutput;
#endif
#if defined INK_LIGHT
flat in vec4 splatVSOutput[];
flat out vec4 splatGSOutput;
#ifdef INK_COARSE
flat in vec4 gaussiansVSOutput[];
flat out vec4 gaussiansGSOutput;
#endif
#elif defined INK_PEEL
flat in vec3 splatVSOutput[];
flat out vec3 splatGSOutput;
#else
flat in float splatVSOutput[];
flat out float splatGSOutput;
#endif
#ifdef INK_ID
flat in int idVSOutput[];
flat out int idGSOutput;
#endif
#ifdef INK_COLORS
flat in vec4 colorVSOutput[];
flat out vec4 colorGSOutput;
#endif

void main()
{
  vec4 position = gl_in[0].gl_Position;
  if (position.x > 1.0) // left out
  {
    return;
  }
  vec2 extent = vec2(gl_in[0].gl_PointSize * texel) / targetSize;
  for (int corner = 0; corner < 4; ++corner)
  {
    vec2 side = 2.0 * vec2(float(corner / 2), float(corner % 2)) - 1.0;
    gl_Position = position + vec4(side * extent, 0.0, 0.0);
    toDiscGSOutput = toDiscVSOutput[0];
    centerGSOutput = centerVSOutput[0];
    discGSOutput = discVSOutput[0];
#ifdef INK_EDGES
    firstEdgeGSOutput = firstEdgeVSOutput[0];
    secondEdgeGSOutput = secondEdgeVSOutput[0];
#endif
#ifdef INK_PLANES
    positionGSOutput = positionVSOutput[0];
    axisUGSOutput = axisUVSOutput[0];
    axisVGSOutput = axisVVSOutput[0];
#endif
    splatGSOutput = splatVSOutput[0];
#ifdef INK_COARSE
    gaussiansGSOutput = gaussiansVSOutput[0];
#endif
#ifdef INK_ID
    idGSOutput = idVSOutput[0];
#endif
#ifdef INK_COLORS
    colorGSOutput = colorVSOutput[0];
#endif
    EmitVertex();
  }
  EndPrimitive();
}
