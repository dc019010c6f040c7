// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkPrecision_h
#define InkPrecision_h

#include "vtkInkFiltersCoreModule.h" // for the export macro

/// The name of one of vtkAlgorithm's precision constants: "Single", "Double" or "Default".
VTKINKFILTERSCORE_EXPORT const char* InkNameOfPrecision(int precision);

#endif
