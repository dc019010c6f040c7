// SPDX-License-Identifier: BSD-3-Clause
/// Setters that keep what they are given within its range and refuse, with a warning, what is not a number:
/// VTK's own compare only, and let that through.
#ifndef InkSetters_h
#define InkSetters_h

#include "vtkInkRenderingCoreModule.h" // for the export macro

class vtkObject;

/// Whether the value changed.
VTKINKRENDERINGCORE_EXPORT bool InkSetClamped(
  vtkObject* object, const char* name, double& member, double value, double least, double most);

/// The same of a color in 0..1.
VTKINKRENDERINGCORE_EXPORT bool InkSetColor(
  vtkObject* object, const char* name, double member[3], double red, double green, double blue);

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

/// vtkSetVector3Macro of a color in 0..1.
#define InkSetColorMacro(name)                                                                               \
  virtual void Set##name(double red, double green, double blue)                                              \
  {                                                                                                          \
    if (InkSetColor(this, #name, this->name, red, green, blue))                                              \
    {                                                                                                        \
      this->Modified();                                                                                      \
    }                                                                                                        \
  }                                                                                                          \
  virtual void Set##name(const double color[3])                                                              \
  {                                                                                                          \
    this->Set##name(color[0], color[1], color[2]);                                                           \
  }

#endif
