// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INK::Features

// What each stipple comes to, as numbers.

#ifdef INK_COLORS
flat in vec3 colorVSOutput;
#endif
flat in vec3 toneVSOutput;

uniform vec3 inkColor;

//VTK::Output::Dec

void main()
{
  gl_FragData[0] = vec4(toneVSOutput, 1.0);
#ifdef INK_COLORS
  gl_FragData[1] = vec4(colorVSOutput, 1.0);
#else
  gl_FragData[1] = vec4(inkColor, 1.0);
#endif
}
