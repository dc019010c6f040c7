// SPDX-License-Identifier: BSD-3-Clause
#include "InkStippleView.h"

#include "InkStipplePoints.h"
#include "InkView.h"

#include "Tone/ProjectedSize.h"

#include "vtkCamera.h"
#include "vtkCollectionIterator.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace
{

/// VTK's lights, in view coordinates; suns first, which the shader counts on.
std::vector<ink::StippleLight> FindLights(vtkRenderer* renderer)
{
  std::vector<ink::StippleLight> lights;
  vtkMatrix4x4* worldToView = renderer->GetActiveCamera()->GetModelViewTransformMatrix();
  vtkLightCollection* collection = renderer->GetLights();
  vtkCollectionSimpleIterator cookie;
  collection->InitTraversal(cookie);
  while (vtkLight* light = collection->GetNextLight(cookie))
  {
    if (!light->GetSwitch() || lights.size() == InkStippleView::MostLights)
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
    const glm::dvec3 place(from[0], from[1], from[2]);
    const glm::dvec3 back = place - glm::dvec3(to[0], to[1], to[2]);
    const double length = glm::length(back);
    const glm::vec3 towards = length > 0.0 ? glm::vec3(back / length) : glm::vec3(0.0f, 0.0f, 1.0f);
    if (!light->GetPositional())
    {
      lights.push_back({ glm::vec4(towards, 0.0f), intensity });
      continue;
    }
    ink::StippleLight lamp{ glm::vec4(glm::vec3(place), 1.0f), intensity, -towards };
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
    lights.begin(), lights.end(), [](const ink::StippleLight& light) { return !light.isLamp(); });
  return lights;
}

} // namespace

InkStippleView::InkStippleView(vtkRenderer* renderer, const InkView& view, const InkStipplePoints& points,
  const ink::StippleTone& tone, bool headlight)
{
  const glm::mat4 toView = glm::make_mat4(view.MCVC.data());
  const std::array<double, 6>& box = points.GetLocalBounds();
  float nearest = INFINITY;
  float farthest = -INFINITY;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::vec4 place(box[corner & 1 ? 1 : 0], box[corner & 2 ? 3 : 2], box[corner & 4 ? 5 : 4], 1.0);
    const float distance = -(toView * place).z;
    nearest = std::min(nearest, distance);
    farthest = std::max(farthest, distance);
  }
  this->Tone.parallel = view.Eye[3] == 0.0f;
  this->Tone.middle = 0.5f * (nearest + farthest);
  this->Tone.halfRange = std::max(0.5f * (farthest - nearest), 1e-6f * view.Unit);
  this->Tone.nearest = ink::Resolution::nearestDistance(this->Tone.middle, this->Tone.halfRange);
  // What lies before the near plane is not seen.
  this->Tone.closest = std::max(nearest, view.DepthRange[0]);
  this->Tone.listed = points.GetListed();

  const float size = points.GetElementSize() * view.Unit;
  const auto maximumAt = [&](float distance)
  {
    const float pixel = view.Pixel * (this->Tone.parallel ? 1.0f : distance);
    return ink::maximumStipples(size, pixel * static_cast<float>(view.TileScale), tone.pixelsPerStipple);
  };
  this->Tone.maximumStipples = maximumAt(this->Tone.nearest);
  this->Tone.smallness =
    tone.smallElements.weight(maximumAt(std::max(this->Tone.middle, this->Tone.halfRange)));
  this->Lights = headlight ? std::vector<ink::StippleLight>{ { glm::vec4(0.0f, 0.0f, 1.0f, 0.0f), 1.0f } }
                           : FindLights(renderer);
}
