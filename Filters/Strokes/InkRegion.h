// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkRegion_h
#define InkRegion_h

#include "Mesh/TrianglesWithin.h"

#include "vtkPlane.h"
#include "vtkPlanes.h"

#include <vector>

/// The half-spaces behind planes, whose normals point out of them; none without planes.
inline std::vector<ink::HalfSpace> InkRegion(vtkPlanes* planes)
{
  std::vector<ink::HalfSpace> region;
  for (int i = 0; planes && i < planes->GetNumberOfPlanes(); ++i)
  {
    vtkPlane* plane = planes->GetPlane(i);
    ink::HalfSpace half{};
    glm::dvec3 origin;
    plane->GetNormal(&half.normal.x);
    plane->GetOrigin(&origin.x);
    half.offset = glm::dot(half.normal, origin);
    region.push_back(half);
  }
  return region;
}

#endif
