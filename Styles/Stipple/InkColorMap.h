// SPDX-License-Identifier: BSD-3-Clause
/// Colors for scalars, by the name of a color map or by a list of colors.
#ifndef InkColorMap_h
#define InkColorMap_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkScalarsToColors;

/// What of a color map's description is wrong; empty if it is right.
std::string InkCheckColorMap(const std::string& map);

/// @param map   as InkCheckColorMap takes it
/// @param range values of the first and the last color; empty: those of the scalars
vtkSmartPointer<vtkScalarsToColors> InkMakeColors(
  const std::string& map, const std::vector<double>& range, vtkDataArray* scalars);

#endif
