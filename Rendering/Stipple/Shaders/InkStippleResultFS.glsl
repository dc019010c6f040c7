//VTK::System::Dec

// What each stipple comes to, as numbers.

flat in vec3 colorVSOutput;
flat in vec3 toneVSOutput;

//VTK::Output::Dec

void main()
{
  gl_FragData[0] = vec4(toneVSOutput, 1.0);
  gl_FragData[1] = vec4(colorVSOutput, 1.0);
}
