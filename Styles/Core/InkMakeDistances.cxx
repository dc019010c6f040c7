// SPDX-License-Identifier: BSD-3-Clause
#include "InkMakeDistances.h"

#include "InkImageGrid.h"
#include "InkWithGridField.h"

#include "Fields/Resampling/SliceDistances.h"

#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <vector>

vtkSmartPointer<vtkDataArray> InkMakeDistances(
  vtkImageData* image, vtkDataArray* scalars, double isoValue, bool ofMask, const ink::ThickSlices& slices)
{
  int component = 0;
  const vtkSmartPointer<vtkDataArray> values = InkMakeContiguous(scalars, component);
  auto distances = vtkSmartPointer<vtkFloatArray>::New();
  distances->SetNumberOfValues(scalars->GetNumberOfTuples());
  const ink::ElementMarks hidden = InkGetMarks(image->GetPointData(), vtkDataSetAttributes::HIDDENPOINT);
  InkWithGridField(InkMakeGrid(image, InkExtent(image->GetExtent())), values, component, hidden,
    [&](const auto& field)
    {
      const std::vector<float> all = ink::sliceDistances(field, isoValue, ofMask, slices);
      std::copy(all.begin(), all.end(), distances->GetPointer(0));
      return true;
    });
  return distances;
}
