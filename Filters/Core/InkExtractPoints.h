// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkExtractPoints_h
#define InkExtractPoints_h

#include "vtkInkFiltersCoreModule.h" // for the export macro

#include <cstdint>
#include <span>

class vtkPointSet;
class vtkPolyData;

/// Points by their ids, in their order, with all their arrays and the field data, but without cells.
/// @throws std::bad_alloc
VTKINKFILTERSCORE_EXPORT void InkExtractPoints(
  vtkPointSet* input, std::span<const std::uint32_t> ids, vtkPolyData* output);

#endif
