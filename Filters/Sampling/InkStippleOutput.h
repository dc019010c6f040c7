// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStippleOutput_h
#define InkStippleOutput_h

#include "Core/Progress.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <vector>

class vtkDataArray;
class vtkPolyData;

/// The part of a progress from `begin` to `end`; empty if `progress` is.
ink::Progress InkPartOfProgress(const ink::Progress& progress, double begin, double end);

/// An array's tuples of some ids, in their order: tuple n is that of ids[n].
vtkSmartPointer<vtkDataArray> InkPickTuples(vtkDataArray* array, const std::vector<vtkIdType>& ids);

/// Adds the elements' colors as active scalars, prefixed with "Input" if the stipples have an array of that
/// name.
void InkAddColors(vtkPolyData* output, vtkDataArray* colors);

/// @param bytes the memory per stipple during generation
/// @throws std::invalid_argument when `count` stipples do not fit into the machine's memory
void InkCheckStippleMemory(double count, double bytes);

#endif
