// SPDX-License-Identifier: BSD-3-Clause
#include "InkLights.h"

#include "InkShader.h"

#include "vtkCamera.h"
#include "vtkCollectionIterator.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

std::vector<ink::Light> InkFindLights(vtkRenderer* renderer)
{
  std::vector<ink::Light> lights;
  vtkMatrix4x4* worldToView = renderer->GetActiveCamera()->GetModelViewTransformMatrix();
  vtkLightCollection* collection = renderer->GetLights();
  vtkCollectionSimpleIterator cookie;
  collection->InitTraversal(cookie);
  while (vtkLight* light = collection->GetNextLight(cookie))
  {
    if (!light->GetSwitch() || lights.size() == InkMostLights)
    {
      continue;
    }
    double from[4];
    double to[4];
    light->GetTransformedPosition(from);
    light->GetTransformedFocalPoint(to);
    from[3] = to[3] = 1.0;
    worldToView->MultiplyPoint(from, from);
    worldToView->MultiplyPoint(to, to);
    const double* rgb = light->GetDiffuseColor();
    const double luminance = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
    const auto intensity = static_cast<float>(light->GetIntensity() * luminance);
    const glm::dvec3 position(from[0], from[1], from[2]);
    const glm::dvec3 back = position - glm::dvec3(to[0], to[1], to[2]);
    const double length = glm::length(back);
    const glm::vec3 towards = length > 0.0 ? glm::vec3(back / length) : glm::vec3(0.0f, 0.0f, 1.0f);
    if (!light->GetPositional())
    {
      lights.push_back({ glm::vec4(towards, 0.0f), intensity });
      continue;
    }
    ink::Light lamp{ glm::vec4(glm::vec3(position), 1.0f), intensity, -towards };
    // As VTK has it, a cone of more than 90 degrees is none.
    if (light->GetConeAngle() <= 90.0)
    {
      lamp.coneCosine = static_cast<float>(std::cos(vtkMath::RadiansFromDegrees(light->GetConeAngle())));
      lamp.coneExponent = static_cast<float>(light->GetExponent());
    }
    const double* attenuation = light->GetAttenuationValues();
    lamp.attenuation = { attenuation[0], attenuation[1], attenuation[2] };
    lights.push_back(lamp);
  }
  std::stable_partition(
    lights.begin(), lights.end(), [](const ink::Light& light) { return !light.isLamp(); });
  return lights;
}

std::string InkFindLightFeatures(const std::vector<ink::Light>& lights)
{
  const auto lamps =
    std::count_if(lights.begin(), lights.end(), [](const ink::Light& light) { return light.isLamp(); });
  return InkDefine("INK_LIGHTS", lights.size()) + InkDefine("INK_SUNS", lights.size() - lamps) +
    (lamps > 0 ? InkDefine("INK_LAMPS") : "");
}

void InkSetLightUniforms(vtkShaderProgram* program, const std::vector<ink::Light>& lights)
{
  const int count = static_cast<int>(lights.size());
  if (count > 0)
  {
    constexpr std::size_t most = InkMostLights;
    float positions[4 * most];
    float intensities[most];
    float directions[4 * most];
    float fading[4 * most];
    for (int i = 0; i < count; ++i)
    {
      const ink::Light& light = lights[i];
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
