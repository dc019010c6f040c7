//VTK::System::Dec

// The surface that hides stipples: only its depth counts.

in vec3 pointMC;

uniform mat4 MCVCMatrix;
uniform mat4 VCDCMatrix;
uniform int clipPlaneCount;
uniform vec4 clipPlanesVC[6];

out float keptVSOutput; // negative: cut off by a clipping plane

void main()
{
  vec4 position = MCVCMatrix * vec4(pointMC, 1.0);
  keptVSOutput = 1.0;
  for (int i = 0; i < clipPlaneCount; ++i)
  {
    keptVSOutput = min(keptVSOutput, dot(clipPlanesVC[i], position));
  }
  gl_Position = VCDCMatrix * position;
}
