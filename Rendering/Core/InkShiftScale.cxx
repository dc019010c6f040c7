// SPDX-License-Identifier: BSD-3-Clause
#include "InkShiftScale.h"

#include "vtkDataSetAttributes.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

bool InkIsGhostPoint(vtkUnsignedCharArray* ghosts, vtkIdType point)
{
  constexpr unsigned char marks = vtkDataSetAttributes::DUPLICATEPOINT | vtkDataSetAttributes::HIDDENPOINT;
  return ghosts && point < ghosts->GetNumberOfTuples() && (ghosts->GetValue(point) & marks) != 0;
}

void InkShiftScale::FindFiniteBounds(vtkPoints* points, double bounds[6], vtkUnsignedCharArray* ghosts)
{
  vtkMath::UninitializeBounds(bounds);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]) && !InkIsGhostPoint(ghosts, i))
    {
      const bool first = !vtkMath::AreBoundsInitialized(bounds);
      for (int axis = 0; axis < 3; ++axis)
      {
        bounds[2 * axis] = first ? p[axis] : std::min(bounds[2 * axis], p[axis]);
        bounds[2 * axis + 1] = first ? p[axis] : std::max(bounds[2 * axis + 1], p[axis]);
      }
    }
  }
}

InkShiftScale InkShiftScale::FromBounds(const double bounds[6])
{
  InkShiftScale frame;
  if (!vtkMath::AreBoundsInitialized(bounds))
  {
    return frame;
  }
  frame.Unit = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    frame.Center[axis] = 0.5 * bounds[2 * axis] + 0.5 * bounds[2 * axis + 1];
    frame.Unit = std::max(frame.Unit, bounds[2 * axis + 1] - bounds[2 * axis]);
  }
  if (!(frame.Unit > 0.0) || !std::isfinite(frame.Unit))
  {
    frame.Unit = 1.0;
  }
  return frame;
}
