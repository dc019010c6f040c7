// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkPrecision_h
#define InkPrecision_h

#include "vtkInkFiltersCoreModule.h" // for the export macro

/// What vtkAlgorithm's constants for precision are called: "Single", "Double" or "Default".
VTKINKFILTERSCORE_EXPORT const char* InkNameOfPrecision(int precision);

#endif
