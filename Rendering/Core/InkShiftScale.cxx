// SPDX-License-Identifier: BSD-3-Clause
#include "InkShiftScale.h"

#include "InkGhostPoint.h"

#include "vtkMath.h"
#include "vtkPoints.h"

#include "Core/FiniteBox.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

void InkShiftScale::FindFiniteBounds(vtkPoints* points, double bounds[6], vtkUnsignedCharArray* ghosts)
{
  const ink::FiniteBox box = ink::finiteBox(static_cast<std::size_t>(points->GetNumberOfPoints()),
    [&](std::size_t i)
    {
      glm::dvec3 p(std::numeric_limits<double>::quiet_NaN());
      if (!InkIsGhostPoint(ghosts, static_cast<vtkIdType>(i)))
      {
        points->GetPoint(static_cast<vtkIdType>(i), &p.x);
      }
      return p;
    });
  vtkMath::UninitializeBounds(bounds);
  for (int axis = 0; axis < 3 && !box.isEmpty(); ++axis)
  {
    bounds[2 * axis] = box.low[axis];
    bounds[2 * axis + 1] = box.high[axis];
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
