// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkAimLight_h
#define InkAimLight_h

#include "vtkLight.h"
#include "vtkMath.h"

#include <cmath>

/// Lets light come from a direction as its viewer sees it, in degrees to the viewer's right and above.
inline void InkAimLight(vtkLight* light, const double direction[2])
{
  const double right = vtkMath::RadiansFromDegrees(direction[0]);
  const double up = vtkMath::RadiansFromDegrees(direction[1]);
  light->SetLightTypeToCameraLight();
  light->SetFocalPoint(0, 0, 0);
  light->SetPosition(std::sin(right) * std::cos(up), std::sin(up), std::cos(right) * std::cos(up));
}

#endif
