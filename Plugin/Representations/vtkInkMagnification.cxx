// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkMagnification.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace
{

/// A thousandth of the height, which marks' sizes are given in, is half a pixel in this many.
constexpr double LowestPixels = 500.0;

constexpr int MostSteps = 3;
/// Where step 0 begins: a view of all lies in its middle, where the steps beside it end.
constexpr double FirstOfStep = std::numbers::sqrt2 / 2.0;
constexpr double Slack = 1.4;

/// Whether a sphere reaches into the view, before or behind anything.
bool IsInView(vtkRenderer* renderer, const double center[3], double radius)
{
  double planes[24]; // left, right, bottom, top, near, far
  renderer->GetActiveCamera()->GetFrustumPlanes(renderer->GetTiledAspectRatio(), planes);
  for (int side = 0; side < 4; ++side)
  {
    const double* plane = planes + 4 * side;
    if (vtkMath::Dot(plane, center) + plane[3] < -radius)
    {
      return false;
    }
  }
  return true;
}

} // namespace

double vtkInkFindMagnification(vtkRenderer* renderer, const vtkBoundingBox& bounds)
{
  const double radius = bounds.IsValid() ? 0.5 * bounds.GetDiagonalLength() : 0.0;
  double center[3];
  bounds.GetCenter(center);
  if (!(radius > 0.0) || !std::isfinite(radius) || !IsInView(renderer, center, radius))
  {
    return 0.0;
  }
  const double pixels = renderer->GetSize()[1];
  const double share = std::min(pixels / LowestPixels, 1.0);
  vtkCamera* camera = renderer->GetActiveCamera();
  if (camera->GetParallelProjection())
  {
    return share * radius / camera->GetParallelScale();
  }
  double away[3];
  vtkMath::Subtract(center, camera->GetPosition(), away);
  const double half = 0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle());
  const double depth = vtkMath::Dot(away, camera->GetDirectionOfProjection()) - 0.5 * radius;
  // The depth in a view that the sphere fills.
  const double depthOfAll = radius / std::sin(half) - 0.5 * radius;
  return depth > 0.0 ? share * depthOfAll / depth : std::numeric_limits<double>::infinity();
}

int vtkInkFollowMagnification(int before, double magnification)
{
  const double begin = FirstOfStep * std::exp2(before);
  if (magnification >= begin / Slack && magnification <= 2.0 * begin * Slack)
  {
    return before;
  }
  const double step = std::floor(std::log2(magnification / FirstOfStep));
  return static_cast<int>(std::clamp<double>(step, -MostSteps, MostSteps));
}
