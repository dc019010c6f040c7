// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include "Core/Progress.h"

#include <filesystem>
#include <string>
#include <vector>

class vtkCellArray;
class vtkDataSet;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace ink::io
{

/// Why cells of this type, a number of VTK's, are not read; empty if they are.
std::string problemOfCellType(double type);

/// VTK trusts what cells say: points that do not exist, or cells that end before they begin, would crash
/// whatever looks at them.
/// @throws ReadError if there are such
void checkCells(vtkCellArray* cells, vtkIdType points, const std::filesystem::path& file);

/// Leaves out arrays with fewer values, or more, than there are points or cells.
/// @param notes which these are, is added
void dropMismatched(vtkDataSet* data, std::vector<std::string>& notes);

/// Reports one half of the work: reading a grid takes about as long as making its surface.
/// @param begin 0, or 0.5 for the second half
inline Progress halfOf(const Progress& progress, double begin)
{
  return [&progress, begin](double done) { return !progress || progress(begin + done / 2.0); };
}

/// What is drawn of a grid, with its point and cell arrays: the outer surface of solid cells, and cells that
/// are faces, lines or vertices; the points of one without cells.
/// @param notes what of it that is, is added
/// @param progress is told of the second half
/// @throws ReadError if its cells are not sound, ReadAborted
vtkSmartPointer<vtkPolyData> surfaceOf(vtkUnstructuredGrid* grid, const std::filesystem::path& file,
  std::vector<std::string>& notes, const Progress& progress);

} // namespace ink::io
