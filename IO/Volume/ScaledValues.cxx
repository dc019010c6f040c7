// SPDX-License-Identifier: BSD-3-Clause
#include "ScaledValues.h"

#include "InkWithValues.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkImageShiftScale.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ink::io
{

int scaledType(int type, const ValueScale& scale)
{
  const auto [slope, intercept] = scale;
  const double bounds[2] = { vtkDataArray::GetDataTypeMin(type) * slope + intercept,
    vtkDataArray::GetDataTypeMax(type) * slope + intercept };
  const bool whole =
    slope == 1.0 && intercept == std::floor(intercept) && type != VTK_FLOAT && type != VTK_DOUBLE;
  const auto fits = [&bounds](double least, double greatest)
  { return std::min(bounds[0], bounds[1]) >= least && std::max(bounds[0], bounds[1]) <= greatest; };
  return whole && fits(VTK_SHORT_MIN, VTK_SHORT_MAX) ? VTK_SHORT
    : whole && fits(VTK_INT_MIN, VTK_INT_MAX)        ? VTK_INT
                                                     : VTK_FLOAT;
}

void scaleValues(vtkImageData* image, const ValueScale& scale)
{
  vtkNew<vtkImageShiftScale> filter;
  filter->SetInputData(image);
  // The filter adds before it multiplies.
  filter->SetShift(scale.intercept / scale.slope);
  filter->SetScale(scale.slope);
  filter->SetOutputScalarType(scaledType(image->GetScalarType(), scale));
  filter->Update();
  // VTK 9.2's filter loses the direction matrix.
  image->GetPointData()->SetScalars(filter->GetOutput()->GetPointData()->GetScalars());
}

void scaleSlices(vtkImageData* image, const std::vector<ValueScale>& scales)
{
  const auto first = static_cast<std::size_t>(image->GetExtent()[4]);
  const auto width = static_cast<std::size_t>(image->GetDimensions()[0]);
  const std::size_t slice = width * static_cast<std::size_t>(image->GetDimensions()[1]);
  vtkDataArray* stored = image->GetPointData()->GetScalars();
  const auto scale = [&](const auto& values)
  {
    auto scaled = vtkSmartPointer<vtkFloatArray>::New();
    scaled->SetName(stored->GetName());
    scaled->SetNumberOfValues(stored->GetNumberOfValues());
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      const auto [slope, intercept] = scales[first + n / slice];
      const double value = slope * static_cast<double>(values[n]) + intercept;
      scaled->SetValue(static_cast<vtkIdType>(n), static_cast<float>(value));
    }
    return scaled;
  };
  image->GetPointData()->SetScalars(InkWithValues(stored, scale));
}

} // namespace ink::io
