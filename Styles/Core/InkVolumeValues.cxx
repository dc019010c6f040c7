// SPDX-License-Identifier: BSD-3-Clause
#include "InkVolumeValues.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSetGet.h"

#include <span>
#include <sstream>

namespace
{

template <class T>
std::vector<ink::IsoSuggestion> SuggestOf(const T* values, vtkImageData* image)
{
  const int* d = image->GetDimensions();
  return ink::suggestIsoValues(
    std::span<const T>(values, static_cast<std::size_t>(image->GetNumberOfPoints())), { d[0], d[1], d[2] });
}

} // namespace

std::vector<ink::IsoSuggestion> InkSuggestIsoValues(vtkImageData* image, const std::string& array)
{
  vtkPointData* data = image->GetPointData();
  vtkDataArray* scalars = array.empty() ? data->GetScalars() : data->GetArray(array.c_str());
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
