// SPDX-License-Identifier: BSD-3-Clause
#pragma once

class vtkImageData;

namespace ink::io
{

/// The type of values that a file says are to be understood as slope * v + intercept: whole numbers stay what
/// they are where they have room.
/// @param type in which they are stored, as VTK_SHORT
int scaledType(int type, double slope, double intercept);

/// Makes slope * v + intercept of the scalars v of an image, of that type.
void scaleValues(vtkImageData* image, double slope, double intercept);

} // namespace ink::io
