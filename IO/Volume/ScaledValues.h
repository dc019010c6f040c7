// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

class vtkImageData;

namespace ink::io
{

/// What a file says that stored values v mean: slope * v + intercept.
struct ValueScale
{
  double slope = 1.0;
  double intercept = 0.0;
  bool operator==(const ValueScale&) const = default;
};

/// The type of scaled values: whole numbers stay what they are where they have room.
/// @param type in which they are stored, as VTK_SHORT
int scaledType(int type, const ValueScale& scale);

/// Scales the scalars of an image, which become of that type.
void scaleValues(vtkImageData* image, const ValueScale& scale);

/// The same, to VTK_FLOAT, where each slice has a scale of its own, by its index along z.
void scaleSlices(vtkImageData* image, const std::vector<ValueScale>& scales);

} // namespace ink::io
