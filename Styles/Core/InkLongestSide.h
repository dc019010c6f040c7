// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkLongestSide_h
#define InkLongestSide_h

#include <span>

class InkStyleProcesses;
class vtkImageData;

/// The longest side, in world units, of the box around all images of all processes; 0 if there are none.
double InkLongestSide(std::span<vtkImageData* const> images, InkStyleProcesses& processes);

#endif
