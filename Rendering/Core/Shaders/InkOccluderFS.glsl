// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

in float keptVSOutput;

//VTK::Output::Dec

void main()
{
  if (keptVSOutput < 0.0)
  {
    discard;
  }
  gl_FragData[0] = vec4(1.0);
}
