// SPDX-License-Identifier: BSD-3-Clause
// Setters of numbers that vtkSetClampMacro and vtkSetVector2Macro would let NaN into.
#ifndef InkSetNumber_h
#define InkSetNumber_h

#include "vtkInkFiltersCoreModule.h" // for the export macro

class vtkObject;

/// Clamps the value and sets the property to it. NaN is refused with one warning; the property stays.
VTKINKFILTERSCORE_EXPORT void InkSetClampedNumber(
  vtkObject* owner, const char* name, double& property, double value, double least, double most);

/// Sets a range. NaN, and an upper end below the lower one, are refused with one warning.
VTKINKFILTERSCORE_EXPORT void InkSetRange(
  vtkObject* owner, const char* name, double (&property)[2], double lower, double upper);

/// Sets a point. Coordinates that are not finite are refused with one warning.
VTKINKFILTERSCORE_EXPORT void InkSetPoint(
  vtkObject* owner, const char* name, double (&property)[3], double x, double y, double z);

#endif
