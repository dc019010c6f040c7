// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStippleOutput_h
#define InkStippleOutput_h

#include "Parallel/ParallelFor.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <functional>
#include <span>

class vtkCellArray;
class vtkDataArray;
class vtkPolyData;

/// What a run is called with and split into: a share of it, or nothing where nobody listens.
ink::Progress InkPartOfProgress(const ink::Progress& progress, double begin, double end);

/// Calls body(0) ... body(count - 1) in parallel, some thousands to a task.
void InkForEach(std::size_t count, const std::function<void(std::size_t)>& body);

/// One VTK_POLY_VERTEX cell for each element: cell e holds the points begins[e] to begins[e + 1], in order.
vtkSmartPointer<vtkCellArray> InkMakePolyVertices(std::span<const vtkIdType> begins);

/// Adds a field array of numbers.
void InkAddField(vtkPolyData* output, const char* name, std::span<const double> values);

/// Adds the elements' colors as active scalars, as "Input..." where the stipples have an array of that name.
void InkAddColors(vtkPolyData* output, vtkDataArray* colors);

/// @param bytes that a stipple takes while it is made
/// @throws std::invalid_argument when so many do not fit into the machine's memory
void InkCheckStippleMemory(double count, double bytes);

#endif
