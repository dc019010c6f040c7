// SPDX-License-Identifier: BSD-3-Clause
#include "InkSetters.h"

#include "vtkObject.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace
{

/// @return whether anything changed
bool Replace(double* member, std::initializer_list<double> values)
{
  const bool changed = !std::equal(values.begin(), values.end(), member);
  std::copy(values.begin(), values.end(), member);
  return changed;
}

} // namespace

bool InkSetClamped(
  vtkObject* object, const char* name, double& member, double value, double least, double most)
{
  if (std::isnan(value))
  {
    vtkWarningWithObjectMacro(object, << name << ": expected a number from " << least << " to " << most
                                      << ", found " << value << "; it stays " << member << '.');
    return false;
  }
  return Replace(&member, { std::clamp(value, least, most) });
}

bool InkSetColor(vtkObject* object, const char* name, double member[3], double red, double green, double blue)
{
  if (std::isnan(red) || std::isnan(green) || std::isnan(blue))
  {
    vtkWarningWithObjectMacro(object, << name << ": expected red, green and blue from 0 to 1, found " << red
                                      << ", " << green << ", " << blue << "; it stays " << member[0] << ", "
                                      << member[1] << ", " << member[2] << '.');
    return false;
  }
  return Replace(
    member, { std::clamp(red, 0.0, 1.0), std::clamp(green, 0.0, 1.0), std::clamp(blue, 0.0, 1.0) });
}

bool InkSetRange(vtkObject* object, const char* name, double member[2], double lower, double upper)
{
  if (!(lower <= upper))
  {
    vtkWarningWithObjectMacro(object, << name << ": expected the lower end and then the upper one, found "
                                      << lower << " and " << upper << "; it stays " << member[0] << " to "
                                      << member[1] << '.');
    return false;
  }
  return Replace(member, { lower, upper });
}

bool InkSetPoint(vtkObject* object, const char* name, double member[3], double x, double y, double z)
{
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
  {
    vtkWarningWithObjectMacro(object, << name << ": expected three finite numbers, found " << x << ", " << y
                                      << ", " << z << "; it stays " << member[0] << ", " << member[1] << ", "
                                      << member[2] << '.');
    return false;
  }
  return Replace(member, { x, y, z });
}
