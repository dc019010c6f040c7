// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkCameraEye_h
#define InkCameraEye_h

#include "Curves/Contours/Eye.h"

#include "vtkCamera.h"

/// Where a camera looks from.
inline ink::Eye InkCameraEye(vtkCamera* camera)
{
  glm::dvec3 v;
  const bool parallel = camera->GetParallelProjection() != 0;
  parallel ? camera->GetDirectionOfProjection(&v.x) : camera->GetPosition(&v.x);
  return parallel ? ink::Eye::along(v) : ink::Eye::at(v);
}

#endif
