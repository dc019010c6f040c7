// SPDX-License-Identifier: BSD-3-Clause
#include "InkWithoutRepeats.h"

#include "InkActiveScalars.h"
#include "InkSubsample.h"

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

} // namespace

vtkSmartPointer<vtkImageData> InkWithoutRepeats(vtkImageData* image, const std::string& array)
{
  vtkPointData* points = image->GetPointData();
  vtkDataArray* values = !array.empty() ? points->GetArray(array.c_str())
    : points->GetScalars()              ? points->GetScalars()
                                        : InkFirstValues(points);
  if (!values || image->GetCellData()->GetNumberOfArrays() > 0 || values->GetNumberOfComponents() != 1 ||
    !values->HasStandardMemoryLayout() || values->GetDataTypeSize() < 1 ||
    values->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    return image;
  }
  std::array<int, 3> dimensions;
  image->GetDimensions(dimensions.data());
  const std::array repeated = ink::findRepeatedSamples(
    values->GetVoidPointer(0), static_cast<std::size_t>(values->GetDataTypeSize()), dimensions);
  if (std::none_of(repeated.begin(), repeated.end(), [](const auto& axis) { return axis.step > TooFew; }))
  {
    return image;
  }
  std::array<InkSubsampledAxis, 3> axes;
  std::transform(repeated.begin(), repeated.end(), axes.begin(),
    [](const ink::RepeatedSamples& axis) {
      return InkSubsampledAxis{ axis.indices(), axis.first, axis.step };
    });
  return InkSubsample(image, axes);
}
