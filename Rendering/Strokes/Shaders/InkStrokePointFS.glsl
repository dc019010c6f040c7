// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

flat in vec4 placeVSOutput;
flat in vec4 shapeVSOutput;

//VTK::Output::Dec

void main()
{
  gl_FragData[0] = placeVSOutput;
  gl_FragData[1] = shapeVSOutput;
}
