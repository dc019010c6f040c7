// SPDX-License-Identifier: BSD-3-Clause
#include "ScaledValues.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImageShiftScale.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace ink::io
{

int scaledType(int type, double slope, double intercept)
{
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

void scaleValues(vtkImageData* image, double slope, double intercept)
{
  vtkNew<vtkImageShiftScale> filter;
  filter->SetInputData(image);
  // The filter adds before it multiplies.
  filter->SetShift(intercept / slope);
  filter->SetScale(slope);
  filter->SetOutputScalarType(scaledType(image->GetScalarType(), slope, intercept));
  filter->Update();
  // VTK 9.2's filter loses the direction matrix.
  image->GetPointData()->SetScalars(filter->GetOutput()->GetPointData()->GetScalars());
}

} // namespace ink::io
