// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkPointOutput_h
#define InkPointOutput_h

#include "vtkInkFiltersCoreModule.h" // for the export macro
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <span>

class vtkCellArray;
class vtkDataArray;
class vtkPoints;

/// One VTK_POLY_VERTEX cell for each element: cell e holds the points begins[e] to begins[e + 1], in order.
VTKINKFILTERSCORE_EXPORT vtkSmartPointer<vtkCellArray> InkMakePolyVertices(std::span<const vtkIdType> begins);

/// One VTK_POLY_VERTEX cell over points 0 ... count - 1; none without points.
VTKINKFILTERSCORE_EXPORT vtkSmartPointer<vtkCellArray> InkMakePolyVertex(vtkIdType count);
/// The same whose points' ids are in an array that is kept for them.
/// @param ids of InkFindIdType(count); gets as many values as there are points
VTKINKFILTERSCORE_EXPORT vtkSmartPointer<vtkCellArray> InkMakePolyVertex(vtkIdType count, vtkDataArray* ids);
/// The smallest type that cells have for the ids of so many points.
VTKINKFILTERSCORE_EXPORT int InkFindIdType(vtkIdType count);

/// The array `Priority` of points in progressive order: i / count, always below 1.
VTKINKFILTERSCORE_EXPORT vtkSmartPointer<vtkDataArray> InkMakePriority(vtkIdType count);
/// The same of points in another order: each is that one, `ranks` of them, in progressive order.
VTKINKFILTERSCORE_EXPORT vtkSmartPointer<vtkDataArray> InkMakePriority(std::span<const std::uint32_t> ranks);

/// The array `SurfaceIndex` of points that lie one surface after the other. @param counts how many each has
VTKINKFILTERSCORE_EXPORT vtkSmartPointer<vtkDataArray> InkMakeSurfaceIndex(
  std::span<const std::size_t> counts);

/// Halves the radius of those samples of rims that are to have less, see ink::rimOuterNormals.
/// @param points samples of iso-surfaces, floats or doubles, those of a rim one after the other
/// @param radii one of each, of the same type
VTKINKFILTERSCORE_EXPORT void InkNarrowRims(vtkPoints* points, vtkDataArray* radii);

/// An array with one value for all points.
VTKINKFILTERSCORE_EXPORT vtkSmartPointer<vtkDataArray> InkMakeConstant(
  const char* name, int type, vtkIdType count, double value);

#endif
