//VTK::System::Dec

// Quads in place of point sprites, where a splat may be larger than the largest point of this OpenGL.

layout(points) in;
layout(triangle_strip, max_vertices = 4) out;

uniform vec2 viewportSize;

flat in vec2 centerVSOutput[];
flat in vec4 toDiscVSOutput[];
flat in vec2 perspectiveVSOutput[];
flat in vec3 positionVSOutput[];
flat in vec3 axisUVSOutput[];
flat in vec3 axisVVSOutput[];
flat in float lightVSOutput[];
flat in float weightVSOutput[];
flat in float slopeVSOutput[];
flat in vec2 toleranceVSOutput[];
flat in int idVSOutput[];

flat out vec2 centerGSOutput;
flat out vec4 toDiscGSOutput;
flat out vec2 perspectiveGSOutput;
flat out vec3 positionGSOutput;
flat out vec3 axisUGSOutput;
flat out vec3 axisVGSOutput;
flat out float lightGSOutput;
flat out float weightGSOutput;
flat out float slopeGSOutput;
flat out vec2 toleranceGSOutput;
flat out int idGSOutput;

void main()
{
  vec4 position = gl_in[0].gl_Position;
  if (position.x > 1.0) // left out
  {
    return;
  }
  vec2 extent = vec2(gl_in[0].gl_PointSize) / viewportSize;
  for (int corner = 0; corner < 4; ++corner)
  {
    vec2 side = 2.0 * vec2(float(corner / 2), float(corner % 2)) - 1.0;
    gl_Position = position + vec4(side * extent, 0.0, 0.0);
    centerGSOutput = centerVSOutput[0];
    toDiscGSOutput = toDiscVSOutput[0];
    perspectiveGSOutput = perspectiveVSOutput[0];
    positionGSOutput = positionVSOutput[0];
    axisUGSOutput = axisUVSOutput[0];
    axisVGSOutput = axisVVSOutput[0];
    lightGSOutput = lightVSOutput[0];
    weightGSOutput = weightVSOutput[0];
    slopeGSOutput = slopeVSOutput[0];
    toleranceGSOutput = toleranceVSOutput[0];
    idGSOutput = idVSOutput[0];
    EmitVertex();
  }
  EndPrimitive();
}
