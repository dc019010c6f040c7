// SPDX-License-Identifier: BSD-3-Clause
#include "InkSetNumber.h"

#include "vtkObject.h"

#include <algorithm>
#include <cmath>

void InkSetClampedNumber(
  vtkObject* owner, const char* name, double& property, double value, double least, double most)
{
  if (std::isnan(value))
  {
    vtkWarningWithObjectMacro(owner, << name << ": expected a number from " << least << " to " << most
                                     << ", found " << value << "; it stays " << property << ".");
    return;
  }
  const double clamped = std::clamp(value, least, most);
  if (property != clamped)
  {
    property = clamped;
    owner->Modified();
  }
}

void InkSetRange(vtkObject* owner, const char* name, double (&property)[2], double lower, double upper)
{
  if (!(lower <= upper))
  {
    vtkWarningWithObjectMacro(owner, << name << ": expected the lower end and then the upper one, found "
                                     << lower << " and " << upper << "; it stays " << property[0] << " to "
                                     << property[1] << ".");
    return;
  }
  if (property[0] != lower || property[1] != upper)
  {
    property[0] = lower;
    property[1] = upper;
    owner->Modified();
  }
}

void InkSetPoint(vtkObject* owner, const char* name, double (&property)[3], double x, double y, double z)
{
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
  {
    vtkWarningWithObjectMacro(owner, << name << ": expected three finite numbers, found " << x << ", " << y
                                     << ", " << z << "; it stays " << property[0] << ", " << property[1]
                                     << ", " << property[2] << ".");
    return;
  }
  if (property[0] != x || property[1] != y || property[2] != z)
  {
    property[0] = x;
    property[1] = y;
    property[2] = z;
    owner->Modified();
  }
}
