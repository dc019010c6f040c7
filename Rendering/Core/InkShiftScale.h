// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkShiftScale_h
#define InkShiftScale_h

#include "vtkInkRenderingCoreModule.h" // for the export macro

#include "vtkType.h"

#include <array>

class vtkPoints;
class vtkUnsignedCharArray;

/// The coordinates in which points are sent to the GPU: relative to the data's center and size, so that in
/// single precision neither large nor tiny coordinates lose digits.
struct VTKINKRENDERINGCORE_EXPORT InkShiftScale
{
  std::array<double, 3> Center{}; ///< the origin, in the data's coordinates
  double Unit = 1.0;              ///< data units per unit

  /// The frame of data with these bounds, written as VTK writes bounds; they may be uninitialized.
  static InkShiftScale FromBounds(const double bounds[6]);

  /// The bounds of the finite points; uninitialized bounds if there are none. (vtkPoints' own bounds may
  /// count points that are not finite.)
  /// @param ghosts `vtkGhostType` or null: points that it marks do not count
  static void FindFiniteBounds(vtkPoints* points, double bounds[6], vtkUnsignedCharArray* ghosts = nullptr);

  /// A point of the data in the frame's coordinates.
  void ToLocal(const double point[3], float local[3]) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      local[axis] = static_cast<float>((point[axis] - this->Center[axis]) / this->Unit);
    }
  }
};

#endif
