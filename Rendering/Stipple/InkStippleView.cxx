// SPDX-License-Identifier: BSD-3-Clause
#include "InkStippleView.h"

#include "InkLights.h"
#include "InkStipplePoints.h"
#include "InkViewUniforms.h"

#include "Tone/Stipple/ProjectedSize.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

InkStippleView::InkStippleView(vtkRenderer* renderer, const InkViewUniforms& view,
  const InkStipplePoints& points, const ink::stipple::Tone& tone, bool headlight)
{
  const glm::mat4 toView = glm::make_mat4(view.MCVC.data());
  const std::array<double, 6>& box = points.GetLocalBounds();
  float nearest = INFINITY;
  float farthest = -INFINITY;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::vec4 point(box[corner & 1 ? 1 : 0], box[corner & 2 ? 3 : 2], box[corner & 4 ? 5 : 4], 1.0);
    const float distance = -(toView * point).z;
    nearest = std::min(nearest, distance);
    farthest = std::max(farthest, distance);
  }
  this->Tone.parallel = view.Eye[3] == 0.0f;
  this->Tone.middle = 0.5f * (nearest + farthest);
  this->Tone.halfRange = std::max(0.5f * (farthest - nearest), 1e-6f * view.Unit);
  this->Tone.nearest = ink::stipple::Resolution::nearestDistance(this->Tone.middle, this->Tone.halfRange);
  // What lies before the near plane is not seen.
  this->Tone.closest = std::max(nearest, view.DepthRange[0]);
  this->Tone.listed = points.GetListed();

  const float size = points.GetElementSize() * view.Unit;
  const auto maximumAt = [&](float distance)
  {
    const float pixel = view.Pixel * (this->Tone.parallel ? 1.0f : distance);
    return ink::stipple::maximumStipples(
      size, pixel * static_cast<float>(view.TileScale), tone.pixelsPerStipple);
  };
  this->Tone.maximumStipples = maximumAt(this->Tone.nearest);
  this->Tone.smallness =
    tone.smallElements.weight(maximumAt(std::max(this->Tone.middle, this->Tone.halfRange)));
  this->Lights = headlight ? std::vector<ink::Light>{ { glm::vec4(0.0f, 0.0f, 1.0f, 0.0f), 1.0f } }
                           : InkFindLights(renderer);
}
