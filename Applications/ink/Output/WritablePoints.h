// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PointFile.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace ink::cli
{

/// Points with those of their point arrays that a PointStore and a format can have: arrays of numbers, all of
/// them with names. What PLY has no type for becomes numbers of double precision.
/// @param notes what is left out or changed, each a sentence without its dot, is added
vtkSmartPointer<vtkPolyData> writablePoints(
  vtkPolyData* points, PointFormat format, std::vector<std::string>& notes);

} // namespace ink::cli
