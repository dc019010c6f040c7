// SPDX-License-Identifier: BSD-3-Clause
// Setters that refuse NaN, which vtkSetClampMacro and
// vtkSetVector2Macro let through.
#ifndef InkSetNumber_h
#define InkSetNumber_h

#include "vtkInkFiltersCoreModule.h" // for the export macro

class vtkObject;

/// Sets the property to the clamped value. NaN is refused with one warning; the property keeps its value.
VTKINKFILTERSCORE_EXPORT void InkSetClampedNumber(
  vtkObject* owner, const char* name, double& property, double value, double least, double most);

/// Sets a range. NaN, and an upper end below the lower one, are refused with one warning.
VTKINKFILTERSCORE_EXPORT void InkSetRange(
  vtkObject* owner, const char* name, double (&property)[2], double lower, double upper);

/// Sets a point. Coordinates that are not finite are refused with one warning.
VTKINKFILTERSCORE_EXPORT void InkSetPoint(
  vtkObject* owner, const char* name, double (&property)[3], double x, double y, double z);

#endif
