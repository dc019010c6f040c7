// SPDX-License-Identifier: BSD-3-Clause
#include "InkVolumeValues.h"

#include "InkImageGrid.h"

#include "Fields/Grid/GridField.h"
#include "Statistics/NoiseEstimate.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSetGet.h"

#include <span>
#include <sstream>
#include <type_traits>

namespace
{

template <class T>
std::optional<ink::IsoSuggestion> SuggestOf(const T* values, vtkImageData* image)
{
  const int* d = image->GetDimensions();
  return ink::suggestIsoValue(
    std::span<const T>(values, static_cast<std::size_t>(image->GetNumberOfPoints())), { d[0], d[1], d[2] });
}

vtkDataArray* FindScalars(vtkImageData* image, const std::string& array)
{
  vtkPointData* data = image->GetPointData();
  return array.empty() ? data->GetScalars() : data->GetArray(array.c_str());
}

} // namespace

double InkSuggestSmoothing(vtkImageData* image, const std::string& array, double isoValue)
{
  vtkDataArray* found = FindScalars(image, array);
  if (!found || found->GetNumberOfComponents() != 1)
  {
    return 0.0;
  }
  const ink::GridGeometry grid = InkMakeGrid(image, InkExtent(image->GetExtent()));
  int component = 0;
  const vtkSmartPointer<vtkDataArray> scalars = InkMakeContiguous(found, component);
  const auto suggest = [&](const auto* values)
  {
    using T = std::remove_cv_t<std::remove_pointer_t<decltype(values)>>;
    const std::span<const T> all(values, static_cast<std::size_t>(scalars->GetNumberOfValues()));
    return ink::suggestSmoothing(ink::estimateNoise(ink::GridField<T>(grid, all), isoValue), grid.spacing());
  };
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(return suggest(static_cast<const VTK_TT*>(scalars->GetVoidPointer(0))));
  }
  return 0.0;
}

std::optional<ink::IsoSuggestion> InkSuggestIsoValue(vtkImageData* image, const std::string& array)
{
  vtkDataArray* scalars = FindScalars(image, array);
  if (!scalars)
  {
    return std::nullopt;
  }
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(return SuggestOf(static_cast<const VTK_TT*>(scalars->GetVoidPointer(0)), image));
  }
  return std::nullopt;
}

std::string InkNameOfMethod(ink::IsoSuggestion::Method method)
{
  return method == ink::IsoSuggestion::Method::Boundary ? "the lowest clear boundary between two materials"
                                                        : "Otsu's threshold, as no boundary is clear";
}

std::string InkFormatShort(double number)
{
  std::ostringstream stream;
  stream.precision(7);
  // Plus zero: no -0.
  stream << number + 0.0;
  return stream.str();
}
