// SPDX-License-Identifier: BSD-3-Clause
#include "InkVolumeValues.h"

#include "InkImageGrid.h"

#include "Core/FormatNumber.h"
#include "Fields/Grid/GridField.h"
#include "IsoSurface/ActiveCellBound.h"
#include "Statistics/NoiseEstimate.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSetGet.h"

#include <numeric>
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

/// What `find` makes of the values, a span, of an array of one component; 0 where there is none.
template <class Find>
double EvaluateScalars(vtkImageData* image, const std::string& array, const Find& find)
{
  vtkDataArray* found = InkFindScalars(image, array);
  if (!found || found->GetNumberOfComponents() != 1)
  {
    return 0.0;
  }
  int component = 0;
  const vtkSmartPointer<vtkDataArray> scalars = InkMakeContiguous(found, component);
  const std::size_t count = static_cast<std::size_t>(scalars->GetNumberOfValues());
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(return find(std::span(static_cast<const VTK_TT*>(scalars->GetVoidPointer(0)), count)));
  }
  return 0.0;
}

} // namespace

vtkDataArray* InkFindScalars(vtkImageData* image, const std::string& array)
{
  vtkPointData* data = image->GetPointData();
  return array.empty() ? data->GetScalars() : data->GetArray(array.c_str());
}

double InkSuggestSmoothing(vtkImageData* image, const std::string& array, double isoValue)
{
  const ink::GridGeometry grid = InkMakeGrid(image, InkExtent(image->GetExtent()));
  return EvaluateScalars(image, array,
    [&]<class T>(std::span<const T> values)
    {
      return ink::suggestSmoothing(
        ink::estimateNoise(ink::GridField<T>(grid, values), isoValue), grid.spacing());
    });
}

double InkBoundSurfacePoints(vtkImageData* image, const std::string& array, double isoValue)
{
  const int* d = image->GetDimensions();
  return EvaluateScalars(image, array,
    [&]<class T>(std::span<const T> values)
    {
      const std::vector<std::size_t> counts =
        ink::boundActiveCells(values, { d[0], d[1], d[2] }, isoValue, ink::CrossingRule::HalfOpen);
      return std::accumulate(counts.begin(), counts.end(), 0.0);
    });
}

std::vector<ink::IsoSuggestion> InkSuggestIsoValues(vtkImageData* image, const std::string& array)
{
  vtkDataArray* scalars = InkFindScalars(image, array);
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
    : suggestion.boundary == Boundary::Sign ? "where the sign changes, as no boundary is clear"
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
      ink::formatNumber(suggestions[i].value) + ": " + InkDescribe(suggestions[i]);
  }
  return text;
}
