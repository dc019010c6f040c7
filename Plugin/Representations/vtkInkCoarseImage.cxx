// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkCoarseImage.h"

#include "InkSubsample.h"

#include "vtkImageData.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{

std::array<int, 3> CountPoints(vtkImageData* image, const std::array<int, 3>& strides)
{
  const int* points = image->GetDimensions();
  std::array<int, 3> taken;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    taken[axis] = (points[axis] - 1) / strides[axis] + 1;
  }
  return taken;
}

/// How many points further the next one is along each axis: as evenly spaced in the world as that goes.
std::array<int, 3> FindStrides(vtkImageData* image, vtkIdType mostPoints)
{
  std::array<double, 3> spacing;
  std::transform(image->GetSpacing(), image->GetSpacing() + 3, spacing.begin(),
    [](double step) { return step != 0.0 ? std::abs(step) : 1.0; });
  const double finest = *std::min_element(spacing.begin(), spacing.end());
  const int* points = image->GetDimensions();
  const int longest = *std::max_element(points, points + 3);
  std::array strides{ 1, 1, 1 };
  for (int apart = 1; apart <= longest; ++apart)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double along = std::round(apart * finest / spacing[axis]);
      // An axis of several points keeps two.
      strides[axis] = static_cast<int>(std::clamp(along, 1.0, std::max(points[axis] - 1.0, 1.0)));
    }
    const auto [x, y, z] = CountPoints(image, strides);
    if (vtkIdType{ x } * y * z <= mostPoints)
    {
      break;
    }
  }
  return strides;
}

} // namespace

vtkSmartPointer<vtkImageData> vtkInkCoarseImage(vtkImageData* image, vtkIdType mostPoints)
{
  const std::array strides = FindStrides(image, mostPoints);
  if (strides == std::array{ 1, 1, 1 })
  {
    return image;
  }
  std::array<InkSubsampledAxis, 3> axes;
  const std::array taken = CountPoints(image, strides);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    axes[axis].Step = strides[axis];
    for (int i = 0; i < taken[axis]; ++i)
    {
      axes[axis].Indices.push_back(i * strides[axis]);
    }
  }
  return InkSubsample(image, axes);
}
