// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkPointOutput_h
#define InkPointOutput_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <span>

class vtkCellArray;
class vtkDataArray;

/// One VTK_POLY_VERTEX cell over points 0 ... count - 1.
vtkSmartPointer<vtkCellArray> InkMakePolyVertex(vtkIdType count);

/// The array `Priority` of points in progressive order: i / count, always below 1.
vtkSmartPointer<vtkDataArray> InkMakePriority(vtkIdType count);
/// The same of points in another order: each is that one, `ranks` of them, in progressive order.
vtkSmartPointer<vtkDataArray> InkMakePriority(std::span<const std::uint32_t> ranks);

/// An array with one value for all points.
vtkSmartPointer<vtkDataArray> InkMakeConstant(const char* name, int type, vtkIdType count, double value);

#endif
