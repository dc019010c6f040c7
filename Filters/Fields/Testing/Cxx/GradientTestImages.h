// SPDX-License-Identifier: BSD-3-Clause
// Images for the tests of vtkInkGradient.
#ifndef GradientTestImages_h
#define GradientTestImages_h

#include "InkTestVolume.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>

/// An image of the given type and extent, turned in space, whose one scalar is function(x, y, z) of the world
/// point.
template <class Function>
vtkSmartPointer<vtkImageData> MakeImage(int type, const std::array<int, 6>& extent, Function function,
  const std::array<double, 3>& spacing = { 1.0, 0.5, 2.0 })
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(const_cast<int*>(extent.data()));
  image->SetSpacing(spacing.data());
  image->SetOrigin(3.0, -2.0, 1.0);
  image->SetDirectionMatrix(0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0);
  InkTestFill(image, type, function);
  return image;
}

/// The largest difference of two arrays' components; huge where they differ in size.
inline double LargestDifference(vtkDataArray* a, vtkDataArray* b)
{
  if (!a || !b || a->GetNumberOfTuples() != b->GetNumberOfTuples() ||
    a->GetNumberOfComponents() != b->GetNumberOfComponents())
  {
    return VTK_DOUBLE_MAX;
  }
  double largest = 0.0;
  for (vtkIdType n = 0; n < a->GetNumberOfTuples(); ++n)
  {
    for (int c = 0; c < a->GetNumberOfComponents(); ++c)
    {
      const double difference = std::abs(a->GetComponent(n, c) - b->GetComponent(n, c));
      // A NaN is as far away as can be.
      largest = difference >= 0.0 ? std::max(largest, difference) : VTK_DOUBLE_MAX;
    }
  }
  return largest;
}

#endif
