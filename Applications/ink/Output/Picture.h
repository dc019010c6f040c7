// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSmartPointer.h"

class vtkImageData;
class vtkRenderWindow;
class vtkUnsignedCharArray;

namespace ink::cli
{

/// The picture in window, red, green and blue, made smaller by a factor: each pixel is the mean of factor x
/// factor rendered ones, which smooths edges and lines alike.
vtkSmartPointer<vtkImageData> takePicture(vtkRenderWindow* window, int factor);

/// A picture with alpha as PNG has it, not multiplied into the colors, from the same scene before black and
/// before white: where both are equal, the scene hides the background. What alpha VTK itself leaves behind
/// depends on how it blends, and that on its version.
vtkSmartPointer<vtkImageData> findAlpha(vtkImageData* onBlack, vtkImageData* onWhite);

/// picture as a PNG file in memory.
vtkSmartPointer<vtkUnsignedCharArray> encodePng(vtkImageData* picture);

} // namespace ink::cli
