// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkCameraFit.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkInkCameraFit);

namespace
{

/// The axes of a camera's view, unit and at right angles.
struct ViewAxes
{
  double Right[3];
  double Up[3];
  double Direction[3];

  explicit ViewAxes(vtkCamera* camera)
  {
    vtkMatrix4x4* matrix = camera->GetViewTransformMatrix();
    for (int i = 0; i < 3; ++i)
    {
      this->Right[i] = matrix->GetElement(0, i);
      this->Up[i] = matrix->GetElement(1, i);
      this->Direction[i] = -matrix->GetElement(2, i);
    }
  }
};

/// The slope of the upper side of what may be filled against the direction of view; 0 for parallel
/// projection.
double SlopeOf(vtkCamera* camera, double margin)
{
  return camera->GetParallelProjection()
    ? 0.0
    : (1.0 - margin) * std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2);
}

} // namespace

vtkInkCameraFit::vtkInkCameraFit() = default;

vtkInkCameraFit::~vtkInkCameraFit() = default;

void vtkInkCameraFit::Interval::Add(double value)
{
  this->Least = std::min(this->Least, value);
  this->Greatest = std::max(this->Greatest, value);
}

void vtkInkCameraFit::AddPoints(vtkPoints* points, vtkCamera* camera)
{
  const ViewAxes axes(camera);
  const double slopeY = SlopeOf(camera, this->Margin);
  const double slopeX = slopeY * this->Aspect;
  // A point at (x, y, depth) is left of the right side of the view if x - slopeX depth is less than for a
  // point on that side, and so on: the extremes alone matter.
  for (vtkIdType i = 0; points && i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    vtkMath::Subtract(p, this->Pivot, p);
    const double x = vtkMath::Dot(p, axes.Right);
    const double y = vtkMath::Dot(p, axes.Up);
    const double depth = vtkMath::Dot(p, axes.Direction);
    if (std::isfinite(x + y + depth))
    {
      this->Sides[0].Add(x + slopeX * depth);
      this->Sides[1].Add(x - slopeX * depth);
      this->Sides[2].Add(y + slopeY * depth);
      this->Sides[3].Add(y - slopeY * depth);
      this->Depths.Add(depth);
    }
  }
}

void vtkInkCameraFit::Apply(vtkCamera* camera)
{
  const auto& [left, right, bottom, top] = this->Sides;
  const Interval& depths = this->Depths;
  if (depths.Least > depths.Greatest)
  {
    return;
  }
  const ViewAxes axes(camera);
  const double slopeY = SlopeOf(camera, this->Margin);
  const double slopeX = slopeY * this->Aspect;
  const double size =
    std::max({ left.Greatest - right.Least, bottom.Greatest - top.Least, depths.Greatest - depths.Least });
  const double centerX = (right.Greatest + left.Least) / 2;
  const double centerY = (top.Greatest + bottom.Least) / 2;
  double depth = depths.Least - (size > 0 ? size : 1.0);
  if (camera->GetParallelProjection())
  {
    const double halfWidth = (right.Greatest - left.Least) / 2;
    const double halfHeight = (top.Greatest - bottom.Least) / 2;
    const double scale = std::max(halfWidth / this->Aspect, halfHeight) / (1.0 - this->Margin);
    camera->SetParallelScale(scale > 0 ? scale : 1.0);
  }
  else
  {
    depth =
      std::min((left.Least - right.Greatest) / (2 * slopeX), (bottom.Least - top.Greatest) / (2 * slopeY));
    // One point, or points in a line along the view, would put the camera on them.
    depth = std::min(depth, depths.Least - (size > 0 ? 1e-3 * size : 1.0));
  }

  double position[3];
  double focus[3];
  const double focusDepth = (depths.Least + depths.Greatest) / 2;
  for (int i = 0; i < 3; ++i)
  {
    position[i] = this->Pivot[i] + centerX * axes.Right[i] + centerY * axes.Up[i] + depth * axes.Direction[i];
    focus[i] = position[i] + (focusDepth - depth) * axes.Direction[i];
  }
  camera->SetPosition(position);
  camera->SetFocalPoint(focus);
  camera->SetViewUp(axes.Up);
}

void vtkInkCameraFit::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Aspect: " << this->Aspect << "\n"
     << indent << "Margin: " << this->Margin << "\n"
     << indent << "Pivot: " << this->Pivot[0] << ", " << this->Pivot[1] << ", " << this->Pivot[2] << "\n";
}
