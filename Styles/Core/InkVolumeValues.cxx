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
std::optional<ink::IsoSuggestion> SuggestOf(const T* values, vtkImageData* image)
{
  const int* d = image->GetDimensions();
  return ink::suggestIsoValue(
    std::span<const T>(values, static_cast<std::size_t>(image->GetNumberOfPoints())), { d[0], d[1], d[2] });
}

} // namespace

std::optional<ink::IsoSuggestion> InkSuggestIsoValue(vtkImageData* image, const std::string& array)
{
  vtkPointData* data = image->GetPointData();
  vtkDataArray* scalars = array.empty() ? data->GetScalars() : data->GetArray(array.c_str());
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
