#pragma once

#include "Input.h"

class vtkImageData;

namespace ink::cli
{

/// Makes an Input from what a reader of volumes gave: its scalars, one component of them.
/// \throw Failure if there are no voxels or no values at them.
Input makeVolumeInput(vtkImageData* image, const std::filesystem::path& file, const std::string& format);

/// Applies the factor and offset by which a file says its stored values are to be understood.
void rescale(Input& input, double slope, double intercept);

} // namespace ink::cli
