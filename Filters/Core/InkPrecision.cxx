// SPDX-License-Identifier: BSD-3-Clause
#include "InkPrecision.h"

#include "vtkAlgorithm.h"

const char* InkNameOfPrecision(int precision)
{
  return precision == vtkAlgorithm::SINGLE_PRECISION ? "Single"
    : precision == vtkAlgorithm::DOUBLE_PRECISION    ? "Double"
                                                     : "Default";
}
