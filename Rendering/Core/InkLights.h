// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkLights_h
#define InkLights_h

#include "vtkInkRenderingCoreModule.h" // for the export macro

#include "Tone/Light.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkRenderer;
class vtkShaderProgram;

/// No more lights than this are used: the first of the renderer's that are on.
constexpr std::size_t InkMostLights = 8;

/// A renderer's lights in view coordinates, those with parallel rays first, which the shader counts on.
VTKINKRENDERINGCORE_EXPORT std::vector<ink::Light> InkFindLights(vtkRenderer* renderer);

/// The definitions that Shaders/InkLighting.glsl needs for some lights.
VTKINKRENDERINGCORE_EXPORT std::string InkFindLightFeatures(const std::vector<ink::Light>& lights);

/// Its uniforms.
VTKINKRENDERINGCORE_EXPORT void InkSetLightUniforms(
  vtkShaderProgram* program, const std::vector<ink::Light>& lights);

#endif
