// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkTextureFile_h
#define InkTextureFile_h

#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;

/// Reads the texture of strokes from an image file: of 8 bits and 1 or 4 components, as
/// vtkInkStrokeMapper::SetTexture takes it.
/// @param problem what was found in place of such a file; empty if nothing is wrong
/// @return null without a file name, and where something is wrong
vtkSmartPointer<vtkImageData> InkReadTexture(const std::string& file, std::string& problem);

/// What is wrong with the file; empty if nothing is, or where no file is named.
std::string InkCheckTexture(const std::string& file);

#endif
