#pragma once

#include <vector>

#include "vtkSmartPointer.h"

class vtkImageData;
class vtkRenderWindow;
class vtkUnsignedCharArray;

namespace ink::cli
{

/// The picture in window, made smaller by a factor: each pixel is the mean of factor x factor rendered ones,
/// which smooths edges and lines alike. \param transparent four components with straight alpha, as PNG has
/// them, instead of three.
vtkSmartPointer<vtkImageData> takePicture(vtkRenderWindow* window, int factor, bool transparent);

/// picture as a PNG file in memory.
vtkSmartPointer<vtkUnsignedCharArray> encodePng(vtkImageData* picture);

} // namespace ink::cli
