// SPDX-License-Identifier: BSD-3-Clause
#include "InkStippleUniforms.h"

#include "InkLights.h"
#include "InkStippleView.h"

#include "vtkShaderProgram.h"

namespace
{

void SetColor(vtkShaderProgram* program, const char* name, const ink::HlsColor& color)
{
  const float values[3] = { color.hue, color.lightness, color.saturation };
  program->SetUniform3f(name, values);
}

void SetPair(vtkShaderProgram* program, const char* name, float a, float b)
{
  const float values[2] = { a, b };
  program->SetUniform2f(name, values);
}

void SetTriple(vtkShaderProgram* program, const char* name, float a, float b, float c)
{
  const float values[3] = { a, b, c };
  program->SetUniform3f(name, values);
}

} // namespace

void InkSetStippleUniforms(
  vtkShaderProgram* program, const ink::stipple::Tone& tone, const InkStippleView& view, float scale)
{
  program->SetUniformf("listed", view.Tone.listed);
  program->SetUniformf("maximumStipples", view.Tone.maximumStipples);
  program->SetUniformf("smallness", view.Tone.smallness);
  program->SetUniformf("nearest", view.Tone.nearest);
  program->SetUniformf("middle", view.Tone.middle);
  program->SetUniformf("halfRange", view.Tone.halfRange);

  program->SetUniformi("surface", tone.surface);
  program->SetUniformi("twoSided", tone.twoSided);
  program->SetUniformi("boundaryOn", tone.boundary.on);
  program->SetUniformi("silhouetteOn", tone.silhouette.on);
  program->SetUniformi("resolutionOn", tone.resolution.on);
  program->SetUniformi("lightingOn", tone.lighting.on);
  program->SetUniformi("distanceOn", tone.distance.on);
  program->SetUniformi("interiorOn", tone.interior.on);
  SetTriple(program, "boundary", tone.boundary.base, tone.boundary.gain, tone.boundary.exponent);
  SetTriple(program, "silhouette", tone.silhouette.base, tone.silhouette.gain, tone.silhouette.exponent);
  SetPair(program, "resolution", tone.resolution.exponent, tone.resolution.slantExponent);
  SetPair(program, "lighting", tone.lighting.exponent, tone.lighting.facingCosine);
  program->SetUniformi("lightInk", tone.lighting.lightInk);
  SetPair(program, "distanceK", tone.distance.exponent, tone.distance.size);
  SetPair(program, "interior", tone.interior.exponent, tone.interior.size);
  program->SetUniformf("fade", tone.smallElements.fade);
  program->SetUniformf("valueEffect", tone.valueEffect);
  program->SetUniformi("growWithZoom", tone.growWithZoom);
  program->SetUniformi("fadeBySize", tone.fadeBySize);
  program->SetUniformf("diameter", tone.diameter * scale);
  SetColor(program, "warm", tone.warmCool.warm);
  SetColor(program, "cool", tone.warmCool.cool);
  SetTriple(program, "warmCool", tone.warmCool.tone, tone.warmCool.distance, tone.warmCool.amount);
  InkSetLightUniforms(program, view.Lights);
}
