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
std::vector<ink::IsoSuggestion> SuggestOf(const T* values, vtkImageData* image)
{
  const int* d = image->GetDimensions();
  return ink::suggestIsoValues(
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

std::vector<ink::IsoSuggestion> InkSuggestIsoValues(vtkImageData* image, const std::string& array)
{
  vtkDataArray* scalars = FindScalars(image, array);
  if (!scalars)
  {
    return {};
  }
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(return SuggestOf(static_cast<const VTK_TT*>(scalars->GetVoidPointer(0)), image));
  }
  return {};
}

std::string InkDescribe(const ink::IsoSuggestion& suggestion)
{
  using Boundary = ink::IsoSuggestion::Boundary;
  const char* boundary = suggestion.boundary == Boundary::Outermost ? "the outermost clear boundary"
    : suggestion.boundary == Boundary::Inner                        ? "an inner boundary"
    : suggestion.boundary == Boundary::Densest                      ? "the boundary of the densest part"
                                               : "Otsu's threshold, as no boundary is clear";
  std::ostringstream share;
  share.precision(2);
  share << 100 * suggestion.keptShare;
  return boundary + (", keeps " + share.str()) + " % of the volume";
}

std::string InkDescribeChoice(const std::vector<ink::IsoSuggestion>& suggestions)
{
  std::string text = "iso-value ";
  for (std::size_t i = 0; i < suggestions.size(); ++i)
  {
    text += (i == 0      ? ""
                : i == 1 ? "; next best: "
                         : "; ") +
      InkFormatShort(suggestions[i].value) + ": " + InkDescribe(suggestions[i]);
  }
  return text;
}

std::string InkFormatShort(double number)
{
  std::ostringstream stream;
  stream.precision(7);
  // Plus zero: no -0.
  stream << number + 0.0;
  return stream.str();
}
