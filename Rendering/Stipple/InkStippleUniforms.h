// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStippleUniforms_h
#define InkStippleUniforms_h

struct InkStippleView;
class vtkShaderProgram;

namespace ink::stipple
{
struct Tone;
} // namespace ink::stipple

/// Hands the tone's parameters to the vertex shader; all that changes when one of them does.
/// @param scale what diameters are multiplied by, for pictures drawn in tiles
void InkSetStippleUniforms(
  vtkShaderProgram* program, const ink::stipple::Tone& tone, const InkStippleView& view, float scale);

#endif
