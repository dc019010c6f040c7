// SPDX-License-Identifier: BSD-3-Clause
// Setters that keep what they are given within its range and refuse, with one warning, what is not a number:
// VTK's own compare only, and let that through. The functions return whether the property changed; the macros
// stand for VTK's.
#ifndef InkSetters_h
#define InkSetters_h

#include "vtkInkFiltersCoreModule.h" // for the export macro

class vtkObject;

/// The nearest value from least to most.
VTKINKFILTERSCORE_EXPORT bool InkSetClamped(
  vtkObject* object, const char* name, double& member, double value, double least, double most);

/// A color, clamped to 0..1.
VTKINKFILTERSCORE_EXPORT bool InkSetColor(
  vtkObject* object, const char* name, double member[3], double red, double green, double blue);

/// A range; refused, too, where the upper end lies below the lower one.
VTKINKFILTERSCORE_EXPORT bool InkSetRange(
  vtkObject* object, const char* name, double member[2], double lower, double upper);

/// A point; coordinates have to be finite.
VTKINKFILTERSCORE_EXPORT bool InkSetPoint(
  vtkObject* object, const char* name, double member[3], double x, double y, double z);

/// vtkSetClampMacro of a double.
#define InkSetClampMacro(name, least, most)                                                                  \
  virtual void Set##name(double value)                                                                       \
  {                                                                                                          \
    if (InkSetClamped(this, #name, this->name, value, least, most))                                          \
    {                                                                                                        \
      this->Modified();                                                                                      \
    }                                                                                                        \
  }                                                                                                          \
  virtual double Get##name##MinValue()                                                                       \
  {                                                                                                          \
    return least;                                                                                            \
  }                                                                                                          \
  virtual double Get##name##MaxValue()                                                                       \
  {                                                                                                          \
    return most;                                                                                             \
  }

/// vtkSetVector2Macro of a range.
#define InkSetRangeMacro(name)                                                                               \
  virtual void Set##name(double lower, double upper)                                                         \
  {                                                                                                          \
    if (InkSetRange(this, #name, this->name, lower, upper))                                                  \
    {                                                                                                        \
      this->Modified();                                                                                      \
    }                                                                                                        \
  }                                                                                                          \
  virtual void Set##name(const double range[2])                                                              \
  {                                                                                                          \
    this->Set##name(range[0], range[1]);                                                                     \
  }

/// vtkSetVector3Macro by InkSetPoint or InkSetColor.
#define InkSetVector3Macro(name, setter)                                                                     \
  virtual void Set##name(double first, double second, double third)                                          \
  {                                                                                                          \
    if (setter(this, #name, this->name, first, second, third))                                               \
    {                                                                                                        \
      this->Modified();                                                                                      \
    }                                                                                                        \
  }                                                                                                          \
  virtual void Set##name(const double values[3])                                                             \
  {                                                                                                          \
    this->Set##name(values[0], values[1], values[2]);                                                        \
  }
#define InkSetPointMacro(name) InkSetVector3Macro(name, InkSetPoint)
#define InkSetColorMacro(name) InkSetVector3Macro(name, InkSetColor)

#endif
