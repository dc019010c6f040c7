// SPDX-License-Identifier: BSD-3-Clause
#include "InkShiftScale.h"

#include "vtkDataSetAttributes.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include "Core/ParallelChunks.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

bool InkIsGhostPoint(vtkUnsignedCharArray* ghosts, vtkIdType point)
{
  constexpr unsigned char marks = vtkDataSetAttributes::DUPLICATEPOINT | vtkDataSetAttributes::HIDDENPOINT;
  return ghosts && point < ghosts->GetNumberOfTuples() && (ghosts->GetValue(point) & marks) != 0;
}

void InkShiftScale::FindFiniteBounds(vtkPoints* points, double bounds[6], vtkUnsignedCharArray* ghosts)
{
  const double infinity = std::numeric_limits<double>::infinity();
  struct Box
  {
    glm::dvec3 Least;
    glm::dvec3 Greatest;
  };
  const Box none{ glm::dvec3(infinity), glm::dvec3(-infinity) };
  const Box box = ink::parallelReduce(
    static_cast<std::size_t>(points->GetNumberOfPoints()), none,
    [&](std::size_t i)
    {
      glm::dvec3 p;
      points->GetPoint(static_cast<vtkIdType>(i), &p.x);
      const bool isFinite = std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
      return isFinite && !InkIsGhostPoint(ghosts, static_cast<vtkIdType>(i)) ? Box{ p, p } : none;
    },
    [](const Box& a, const Box& b) {
      return Box{ glm::min(a.Least, b.Least), glm::max(a.Greatest, b.Greatest) };
    });
  vtkMath::UninitializeBounds(bounds);
  for (int axis = 0; axis < 3 && box.Least.x <= box.Greatest.x; ++axis)
  {
    bounds[2 * axis] = box.Least[axis];
    bounds[2 * axis + 1] = box.Greatest[axis];
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
