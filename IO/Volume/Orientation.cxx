// SPDX-License-Identifier: BSD-3-Clause
#include "Orientation.h"

#include "vtkImageData.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace ink::io
{
namespace
{

// Directions that are rounded in a file are still at right angles.
constexpr double tolerance = 1e-3;
// Of the cell that three unit vectors span, for them not to lie in a plane.
constexpr double leastVolume = 0.05;

} // namespace

Orientation::Orientation(const double steps[9], const double firstVoxel[3], const double sign[3])
{
  for (int i = 0; i < 3; ++i)
  {
    const double length = vtkMath::Norm(steps + 3 * i);
    for (int j = 0; j < 3; ++j)
    {
      this->direction[i][j] = sign[j] * steps[3 * i + j] / length;
    }
    this->origin[i] = sign[i] * firstVoxel[i];
  }
}

Orientation::Axes Orientation::apply(vtkImageData* image) const
{
  Axes axes = Axes::AtRightAngles;
  for (int i = 0; i < 3; ++i)
  {
    const double* a = this->direction[i];
    const double* b = this->direction[(i + 1) % 3];
    if (!(std::abs(vtkMath::Norm(a) - 1.0) < tolerance) || !std::isfinite(this->origin[i]))
    {
      return Axes::InAPlane;
    }
    axes = std::abs(vtkMath::Dot(a, b)) < tolerance ? axes : Axes::Sheared;
  }
  double d[3][3];
  std::copy_n(&this->direction[0][0], 9, &d[0][0]);
  if (axes == Axes::Sheared)
  {
    if (std::abs(vtkMath::Determinant3x3(d)) < leastVolume)
    {
      return Axes::InAPlane;
    }
    vtkMath::Orthogonalize3x3(this->direction, d);
  }
  image->SetDirectionMatrix(d[0][0], d[1][0], d[2][0], d[0][1], d[1][1], d[2][1], d[0][2], d[1][2], d[2][2]);
  image->SetOrigin(this->origin);
  return axes;
}

} // namespace ink::io
