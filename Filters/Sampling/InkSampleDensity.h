// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSampleDensity_h
#define InkSampleDensity_h

#include <string>

class vtkDataArray;
class vtkPolyData;

/// The density array of that name. @throws std::invalid_argument if it does not fit
vtkDataArray* InkGetDensity(vtkPolyData* mesh, const char* name, int association);

/// A phrase with the numbers of negative values and NaNs; empty if there are none.
std::string InkDescribeUnusableDensity(vtkDataArray* density);

#endif
