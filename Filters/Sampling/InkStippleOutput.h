// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStippleOutput_h
#define InkStippleOutput_h

#include "Core/Progress.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <span>
#include <vector>

class vtkCellArray;
class vtkDataArray;
class vtkPolyData;

/// The part of a progress from `begin` to `end`; empty if `progress` is.
ink::Progress InkPartOfProgress(const ink::Progress& progress, double begin, double end);

/// One VTK_POLY_VERTEX cell for each element: cell e holds the points begins[e] to begins[e + 1], in order.
vtkSmartPointer<vtkCellArray> InkMakePolyVertices(std::span<const vtkIdType> begins);

/// An array's tuples of some ids, in their order: tuple n is that of ids[n].
vtkSmartPointer<vtkDataArray> InkPickTuples(vtkDataArray* array, const std::vector<vtkIdType>& ids);

/// Adds a field array of numbers.
void InkAddField(vtkPolyData* output, const char* name, std::span<const double> values);

/// Adds the elements' colors as active scalars, prefixed with "Input" if the stipples have an array of that
/// name.
void InkAddColors(vtkPolyData* output, vtkDataArray* colors);

/// @param bytes the memory per stipple during generation
/// @throws std::invalid_argument when `count` stipples do not fit into the machine's memory
void InkCheckStippleMemory(double count, double bytes);

#endif
