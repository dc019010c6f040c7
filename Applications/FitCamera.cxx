#include "FitCamera.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ink::cli
{
namespace
{

/// Least and greatest of a number of values.
struct Interval
{
  double least = std::numeric_limits<double>::max();
  double greatest = std::numeric_limits<double>::lowest();

  void add(double value)
  {
    this->least = std::min(this->least, value);
    this->greatest = std::max(this->greatest, value);
  }
};

} // namespace

void fitCamera(
  vtkCamera* camera, const View& view, vtkPoints* points, double aspect, double margin, bool parallel)
{
  double right[3];
  vtkMath::Cross(view.direction, view.up, right);
  const double free = 1.0 - margin;
  const double tangentY =
    parallel ? 0.0 : free * std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2);
  const double tangentX = tangentY * aspect;

  // A point at (x, y, depth) is left of the right side of the view if x - tangentX depth is less than for a
  // point on that side, and so on: the extremes alone matter.
  Interval sides[4];
  Interval depths;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    const double x = vtkMath::Dot(p, right);
    const double y = vtkMath::Dot(p, view.up);
    const double depth = vtkMath::Dot(p, view.direction);
    if (std::isfinite(x + y + depth))
    {
      sides[0].add(x - tangentX * depth);
      sides[1].add(x + tangentX * depth);
      sides[2].add(y - tangentY * depth);
      sides[3].add(y + tangentY * depth);
      depths.add(depth);
    }
  }

  const double size = std::max({ sides[1].greatest - sides[0].least, sides[3].greatest - sides[2].least,
    depths.greatest - depths.least });
  double centerX = (sides[0].greatest + sides[1].least) / 2;
  double centerY = (sides[2].greatest + sides[3].least) / 2;
  double depth = depths.least;
  if (parallel)
  {
    const double halfWidth = (sides[0].greatest - sides[0].least) / 2;
    const double halfHeight = (sides[2].greatest - sides[2].least) / 2;
    const double scale = std::max(halfWidth / aspect, halfHeight) / free;
    camera->ParallelProjectionOn();
    camera->SetParallelScale(scale > 0 ? scale : 1.0);
    depth = depths.least - (size > 0 ? size : 1.0);
  }
  else
  {
    depth = std::min((sides[1].least - sides[0].greatest) / (2 * tangentX),
      (sides[3].least - sides[2].greatest) / (2 * tangentY));
    // One point, or points in a line along the view, would put the camera on them.
    depth = std::min(depth, depths.least - (size > 0 ? 1e-3 * size : 1.0));
  }

  double position[3];
  double focus[3];
  const double focusDepth = (depths.least + depths.greatest) / 2;
  for (int i = 0; i < 3; ++i)
  {
    position[i] = centerX * right[i] + centerY * view.up[i] + depth * view.direction[i];
    focus[i] = position[i] + (focusDepth - depth) * view.direction[i];
  }
  camera->SetPosition(position);
  camera->SetFocalPoint(focus);
  camera->SetViewUp(view.up);
}

} // namespace ink::cli
