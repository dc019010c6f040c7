// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkInkIsDense_h
#define vtkInkIsDense_h

#include "vtkSmartPointer.h"

#include <vector>

class InkStyleProcesses;
class vtkPolyData;

/// Whether lines can be drawn of the points that meshes have, those of all processes together, which call it
/// at once: there are as many as would be made, a million, or no edge is longer than 7 thousandths of the
/// diagonal of their bounds. That is the diagonal of a cell as iso-surfaces of images are sampled in, about.
bool vtkInkIsDense(const std::vector<vtkSmartPointer<vtkPolyData>>& meshes, InkStyleProcesses& processes);

#endif
