// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkInkIOCoreModule.h" // for the export macro

#include <map>
#include <string>

namespace ink::io
{

/// VTK's types of the numbers in raw files, by the names that people give them: int8, uint8, ... uint64,
/// float32, float64.
VTKINKIOCORE_EXPORT const std::map<std::string, int>& numberTypes();

/// Their names, separated by spaces.
VTKINKIOCORE_EXPORT std::string listNumberTypes();

} // namespace ink::io
