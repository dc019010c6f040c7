// SPDX-License-Identifier: BSD-3-Clause
#include "FitCamera.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>

namespace ink::cli
{

void CameraFit::Interval::add(double value)
{
  this->least = std::min(this->least, value);
  this->greatest = std::max(this->greatest, value);
}

CameraFit::CameraFit(double aspect, double margin, bool parallel, const std::array<double, 3>& pivot)
  : Aspect(aspect)
  , Free(1.0 - margin)
  , Parallel(parallel)
  , Pivot(pivot)
{
  if (!parallel)
  {
    vtkNew<vtkCamera> camera;
    this->TangentY = this->Free * std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2);
    this->TangentX = this->TangentY * aspect;
  }
}

void CameraFit::add(vtkPoints* points, const View& view)
{
  double right[3];
  vtkMath::Cross(view.direction, view.up, right);

  // A point at (x, y, depth) is left of the right side of the view if x - tangentX depth is less than for a
  // point on that side, and so on: the extremes alone matter.
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    vtkMath::Subtract(p, this->Pivot.data(), p);
    const double x = vtkMath::Dot(p, right);
    const double y = vtkMath::Dot(p, view.up);
    const double depth = vtkMath::Dot(p, view.direction);
    if (std::isfinite(x + y + depth))
    {
      this->Sides[0].add(x - this->TangentX * depth);
      this->Sides[1].add(x + this->TangentX * depth);
      this->Sides[2].add(y - this->TangentY * depth);
      this->Sides[3].add(y + this->TangentY * depth);
      this->Depths.add(depth);
    }
  }
}

void CameraFit::apply(vtkCamera* camera, const View& view) const
{
  double right[3];
  vtkMath::Cross(view.direction, view.up, right);
  const auto& sides = this->Sides;
  const Interval& depths = this->Depths;
  const double size = std::max({ sides[1].greatest - sides[0].least, sides[3].greatest - sides[2].least,
    depths.greatest - depths.least });
  double centerX = (sides[0].greatest + sides[1].least) / 2;
  double centerY = (sides[2].greatest + sides[3].least) / 2;
  double depth = depths.least;
  if (this->Parallel)
  {
    const double halfWidth = (sides[0].greatest - sides[0].least) / 2;
    const double halfHeight = (sides[2].greatest - sides[2].least) / 2;
    const double scale = std::max(halfWidth / this->Aspect, halfHeight) / this->Free;
    camera->ParallelProjectionOn();
    camera->SetParallelScale(scale > 0 ? scale : 1.0);
    depth = depths.least - (size > 0 ? size : 1.0);
  }
  else
  {
    depth = std::min((sides[1].least - sides[0].greatest) / (2 * this->TangentX),
      (sides[3].least - sides[2].greatest) / (2 * this->TangentY));
    // One point, or points in a line along the view, would put the camera on them.
    depth = std::min(depth, depths.least - (size > 0 ? 1e-3 * size : 1.0));
  }

  double position[3];
  double focus[3];
  const double focusDepth = (depths.least + depths.greatest) / 2;
  for (int i = 0; i < 3; ++i)
  {
    position[i] = this->Pivot[i] + centerX * right[i] + centerY * view.up[i] + depth * view.direction[i];
    focus[i] = position[i] + (focusDepth - depth) * view.direction[i];
  }
  camera->SetPosition(position);
  camera->SetFocalPoint(focus);
  camera->SetViewUp(view.up);
}

} // namespace ink::cli
