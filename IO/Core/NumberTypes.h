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

/// The number of one of these types whose bytes begin here, at any address; of 64 bits it is rounded.
/// @param swapped whether they are in the other order than this machine's
VTKINKIOCORE_EXPORT double numberAt(const void* bytes, int type, bool swapped);

/// Whether a number that was written as text is one of a type, which has a range if it is of integers.
VTKINKIOCORE_EXPORT bool isNumberOf(int type, double number);

} // namespace ink::io
