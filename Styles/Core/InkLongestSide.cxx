// SPDX-License-Identifier: BSD-3-Clause
#include "InkLongestSide.h"

#include "InkStyleProcesses.h"

#include "vtkImageData.h"

#include <algorithm>
#include <array>
#include <limits>

double InkLongestSide(std::span<vtkImageData* const> images, InkStyleProcesses& processes)
{
  // The lower corner, negated, and the upper one.
  std::array<double, 6> corners;
  corners.fill(std::numeric_limits<double>::lowest());
  for (vtkImageData* image : images)
  {
    const double* box = image->GetBounds();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      corners[axis] = std::max(corners[axis], -box[2 * axis]);
      corners[3 + axis] = std::max(corners[3 + axis], box[2 * axis + 1]);
    }
  }
  processes.TakeGreatest(corners);
  return std::max({ corners[0] + corners[3], corners[1] + corners[4], corners[2] + corners[5], 0.0 });
}
