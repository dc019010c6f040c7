// SPDX-License-Identifier: BSD-3-Clause
#include "InkOriginalSamples.h"

#include "InkActiveScalars.h"
#include "InkImageGrid.h"
#include "InkSubsample.h"
#include "InkWithGridField.h"

#include "Statistics/InterpolatedSlices.h"
#include "Statistics/RepeatedSamples.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>

namespace
{

/// Surfaces of labels are smoothed so far that blocks of two do not show, and keep more than those of fewer.
constexpr double TooFew = 2.05;

/// The values to look at; null where there are none, or where points cannot be left out.
vtkDataArray* FindValues(vtkImageData* image, const std::string& array)
{
  vtkPointData* points = image->GetPointData();
  vtkDataArray* values = !array.empty() ? points->GetArray(array.c_str())
    : points->GetScalars()              ? points->GetScalars()
                                        : InkFirstValues(points);
  const bool isFit = values && image->GetCellData()->GetNumberOfArrays() == 0 &&
    values->GetNumberOfComponents() == 1 && values->HasStandardMemoryLayout() &&
    values->GetDataTypeSize() >= 1 && values->GetNumberOfTuples() == image->GetNumberOfPoints();
  return isFit ? values : nullptr;
}

/// @return the image itself where original samples are no more than `most` samples apart along each axis
vtkSmartPointer<vtkImageData> Take(
  vtkImageData* image, const std::array<ink::OriginalSamples, 3>& original, double most)
{
  if (std::none_of(original.begin(), original.end(), [&](const auto& axis) { return axis.step > most; }))
  {
    return image;
  }
  std::array<InkSubsampledAxis, 3> axes;
  std::transform(original.begin(), original.end(), image->GetDimensions(), axes.begin(),
    [](const ink::OriginalSamples& axis, int samples) {
      return InkSubsampledAxis{ axis.indices(samples), axis.first, axis.step };
    });
  return InkSubsample(image, axes);
}

} // namespace

vtkSmartPointer<vtkImageData> InkWithoutRepeats(vtkImageData* image, const std::string& array)
{
  vtkDataArray* values = FindValues(image, array);
  if (!values)
  {
    return image;
  }
  std::array<int, 3> dimensions;
  image->GetDimensions(dimensions.data());
  return Take(image,
    ink::findRepeatedSamples(
      values->GetVoidPointer(0), static_cast<std::size_t>(values->GetDataTypeSize()), dimensions),
    TooFew);
}

vtkSmartPointer<vtkImageData> InkWithoutInterpolatedSlices(vtkImageData* image, const std::string& array)
{
  vtkDataArray* values = FindValues(image, array);
  if (!values)
  {
    return image;
  }
  const auto find = [](const auto& field) { return ink::findInterpolatedSlices(field); };
  return Take(
    image, InkWithGridField(InkMakeGrid(image, InkExtent(image->GetExtent())), values, 0, {}, find), 1.0);
}
