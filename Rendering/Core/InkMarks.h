// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkMarks_h
#define InkMarks_h

#include "vtkType.h"

/// A mapper's marks in one window, as they are on the GPU. Made and destroyed while the window's context is
/// current.
class InkMarks
{
public:
  virtual ~InkMarks() = default;

  /// When they were last uploaded, on VTK's clock; 0: never.
  virtual vtkMTimeType GetUploadTime() const = 0;
};

#endif
