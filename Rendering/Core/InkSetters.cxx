// SPDX-License-Identifier: BSD-3-Clause
#include "InkSetters.h"

#include "vtkObject.h"

#include <algorithm>
#include <cmath>

bool InkSetClamped(
  vtkObject* object, const char* name, double& member, double value, double least, double most)
{
  if (std::isnan(value))
  {
    vtkWarningWithObjectMacro(object, << name << ": expected a number from " << least << " to " << most
                                      << ", found " << value << "; it stays " << member << '.');
    return false;
  }
  const double before = member;
  member = std::clamp(value, least, most);
  return member != before;
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
  const double color[3] = { std::clamp(red, 0.0, 1.0), std::clamp(green, 0.0, 1.0),
    std::clamp(blue, 0.0, 1.0) };
  const bool changed = !std::equal(color, color + 3, member);
  std::copy_n(color, 3, member);
  return changed;
}
