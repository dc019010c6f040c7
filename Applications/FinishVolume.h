#pragma once

#include "Input.h"
#include "PlainVoxels.h"

class vtkImageData;

namespace ink::cli
{

/// Makes an Input from what a reader of volumes gave: its scalars, one component of them.
/// \throw Failure if there are no voxels or no values at them.
Input makeVolumeInput(vtkImageData* image, const std::filesystem::path& file, const std::string& format);

/// The same for a volume whose voxels stay in a file.
/// \param frame where they lie
/// \throw Failure also if memory is not enough for a few slices.
Input makeVolumeInput(
  vtkImageData* frame, const PlainVoxels& voxels, const std::string& format, const Memory& memory);

/// Says how many components the file's voxels have, where makeVolumeInput got but the first.
void setComponents(Input& input, int components);

/// Applies the factor and offset by which a file says its stored values are to be understood.
void rescale(Input& input, double slope, double intercept);

} // namespace ink::cli
