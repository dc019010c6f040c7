// SPDX-License-Identifier: BSD-3-Clause
#include "InkStippleUniforms.h"

#include "InkStippleView.h"

#include "InkOpenGLCompat.h"

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
  vtkShaderProgram* program, const ink::StippleTone& tone, const InkStippleView& view, float scale)
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
  SetTriple(program, "boundary", tone.boundary.kgc, tone.boundary.kgs, tone.boundary.kge);
  SetTriple(program, "silhouette", tone.silhouette.ksc, tone.silhouette.kss, tone.silhouette.kse);
  SetPair(program, "resolution", tone.resolution.krc, tone.resolution.knz);
  SetPair(program, "lighting", tone.lighting.kle, tone.lighting.facingCosine);
  program->SetUniformi("lightInk", tone.lighting.lightInk);
  SetPair(program, "distanceK", tone.distance.kde, tone.distance.size);
  SetPair(program, "interior", tone.interior.kie, tone.interior.size);
  program->SetUniformf("fade", tone.smallElements.fade);
  program->SetUniformf("valueEffect", tone.valueEffect);
  program->SetUniformi("growing", tone.growing);
  program->SetUniformi("appearBySize", tone.appearBySize);
  program->SetUniformf("diameter", tone.diameter * scale);
  SetColor(program, "warm", tone.warmCool.warm);
  SetColor(program, "cool", tone.warmCool.cool);
  SetTriple(program, "warmCool", tone.warmCool.tone, tone.warmCool.distance, tone.warmCool.amount);

  const int count = static_cast<int>(view.Lights.size());
  if (count > 0)
  {
    constexpr std::size_t most = InkStippleView::MostLights;
    float positions[4 * most];
    float intensities[most];
    float directions[4 * most];
    float fading[4 * most];
    for (int i = 0; i < count; ++i)
    {
      const ink::StippleLight& light = view.Lights[i];
      for (int axis = 0; axis < 4; ++axis)
      {
        positions[4 * i + axis] = light.position[axis];
        directions[4 * i + axis] = axis < 3 ? light.direction[axis] : light.coneCosine;
        fading[4 * i + axis] = axis < 3 ? light.attenuation[axis] : light.coneExponent;
      }
      intensities[i] = light.intensity;
    }
    program->SetUniform4fv("lightPositions", count, positions);
    program->SetUniform1fv("lightIntensities", count, intensities);
    program->SetUniform4fv("lampDirections", count, directions);
    program->SetUniform4fv("lampFading", count, fading);
  }
}
