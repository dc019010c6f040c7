// SPDX-License-Identifier: BSD-3-Clause
#include "InkVolumeValues.h"

#include "InkImageGrid.h"
#include "InkImageSlabs.h"
#include "InkWithValues.h"

#include "Core/FormatNumber.h"
#include "Fields/Grid/GridField.h"
#include "IsoSurface/ActiveCellBound.h"
#include "IsoSurface/ActiveCellExtent.h"
#include "Statistics/CoveredSides.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <sstream>

namespace
{

std::array<int, 3> DimensionsOf(vtkImageData* image)
{
  std::array<int, 3> dimensions;
  image->GetDimensions(dimensions.data());
  return dimensions;
}

/// The slices themselves stay where they are when the image that shows them goes.
template <class T>
std::span<const T> ReadSlices(InkImageSlabs& slabs, int begin, int end)
{
  const vtkSmartPointer<vtkImageData> slices = slabs.Get(begin, end);
  vtkDataArray* scalars = slices->GetPointData()->GetScalars();
  return { static_cast<const T*>(scalars->GetVoidPointer(0)),
    static_cast<std::size_t>(scalars->GetNumberOfValues()) };
}

/// What `find` makes of the values, a span, of active scalars of one component; 0 where there are none.
template <class Find>
auto EvaluateScalars(vtkImageData* image, const Find& find) -> decltype(find(std::span<const double>()))
{
  vtkDataArray* found = image->GetPointData()->GetScalars();
  if (!found || found->GetNumberOfComponents() != 1)
  {
    return {};
  }
  int component = 0;
  const vtkSmartPointer<vtkDataArray> scalars = InkMakeContiguous(found, component);
  return InkWithValues(scalars, find);
}

double LongestSide(const std::array<int, 3>& samples, const double spacing[3])
{
  return std::max({ samples[0] * std::abs(spacing[0]), samples[1] * std::abs(spacing[1]),
    samples[2] * std::abs(spacing[2]) });
}

std::string PercentOf(const ink::IsoSuggestion& suggestion)
{
  const double percent = 100.0 * suggestion.keptShare;
  std::ostringstream share;
  share.precision(percent < 99.5 ? 2 : 3);
  share << percent;
  return share.str();
}

} // namespace

ink::SuggestedSmoothing InkSuggestSmoothing(vtkImageData* image, double isoValue)
{
  const ink::GridGeometry grid = InkMakeGrid(image, InkExtent(image->GetExtent()));
  return EvaluateScalars(image,
    [&]<class T>(std::span<const T> values)
    {
      return ink::suggestSmoothings(
        ink::estimateNoise(ink::GridField<T>(grid, values), isoValue), grid.spacing());
    });
}

ink::SuggestedSmoothing InkSuggestSmoothing(
  InkImageSlabs& slabs, double isoValue, const ink::Progress& progress)
{
  const std::array<int, 3>& dimensions = slabs.GetDimensions();
  const vtkSmartPointer<vtkImageData> first = slabs.Get(0, 1);
  return InkWithValues(first->GetPointData()->GetScalars(),
    [&]<class T>(std::span<const T>)
    {
      const ink::SliceReader<T> read = [&](int begin, int end)
      {
        progress(static_cast<double>(begin) / dimensions[2]);
        return ReadSlices<T>(slabs, begin, end);
      };
      const double* spacing = slabs.GetFrame()->GetSpacing();
      return ink::suggestSmoothings(ink::estimateNoise(read, dimensions, slabs.GetAtOnce(), isoValue),
        { spacing[0], spacing[1], spacing[2] });
    });
}

bool InkSurroundsObject(vtkImageData* image, double isoValue)
{
  const std::array<int, 3> dimensions = DimensionsOf(image);
  return EvaluateScalars(image,
    [&]<class T>(std::span<const T> values)
    {
      const ink::SliceReader<T> whole = [values](int, int) { return values; };
      return ink::surroundsObject(ink::coveredSides(whole, dimensions, dimensions[2], isoValue));
    });
}

bool InkSurroundsObject(InkImageSlabs& slabs, double isoValue)
{
  const vtkSmartPointer<vtkImageData> first = slabs.Get(0, 1);
  return InkWithValues(first->GetPointData()->GetScalars(),
    [&]<class T>(std::span<const T>)
    {
      const ink::SliceReader<T> read = [&](int begin, int end) { return ReadSlices<T>(slabs, begin, end); };
      return ink::surroundsObject(
        ink::coveredSides(read, slabs.GetDimensions(), slabs.GetAtOnce(), isoValue));
    });
}

double InkFindSurfaceLength(vtkImageData* image, double isoValue)
{
  const std::array<int, 3> dimensions = DimensionsOf(image);
  return EvaluateScalars(image,
    [&]<class T>(std::span<const T> values)
    {
      const ink::SliceReader<T> whole = [values](int, int) { return values; };
      return LongestSide(
        ink::activeCellExtent(whole, dimensions, dimensions[2], isoValue), image->GetSpacing());
    });
}

double InkFindSurfaceLength(InkImageSlabs& slabs, double isoValue)
{
  const vtkSmartPointer<vtkImageData> first = slabs.Get(0, 1);
  return InkWithValues(first->GetPointData()->GetScalars(),
    [&]<class T>(std::span<const T>)
    {
      const ink::SliceReader<T> read = [&](int begin, int end) { return ReadSlices<T>(slabs, begin, end); };
      return LongestSide(ink::activeCellExtent(read, slabs.GetDimensions(), slabs.GetAtOnce(), isoValue),
        slabs.GetFrame()->GetSpacing());
    });
}

double InkBoundSurfacePoints(vtkImageData* image, double isoValue)
{
  const int* d = image->GetDimensions();
  return EvaluateScalars(image,
    [&]<class T>(std::span<const T> values)
    {
      const std::vector<std::size_t> counts =
        ink::boundActiveCells(values, { d[0], d[1], d[2] }, isoValue, ink::CrossingRule::HalfOpen);
      return std::accumulate(counts.begin(), counts.end(), 0.0);
    });
}

std::vector<ink::IsoSuggestion> InkSuggestIsoValues(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  return scalars ? InkWithValues(scalars,
                     [image](auto values) { return ink::suggestIsoValues(values, DimensionsOf(image)); })
                 : std::vector<ink::IsoSuggestion>();
}

std::vector<ink::IsoSuggestion> InkSuggestIsoValues(InkImageSlabs& slabs, const ink::Progress& progress)
{
  const int count = slabs.GetDimensions()[2];
  if (slabs.IsWhole())
  {
    return InkSuggestIsoValues(slabs.Get(0, count));
  }
  const vtkSmartPointer<vtkImageData> first = slabs.Get(0, 1);
  return InkWithValues(first->GetPointData()->GetScalars(),
    [&]<class T>(std::span<const T>)
    {
      // More often where slices have to be smoothed, or padding surrounds others.
      constexpr double passes = 2.0;
      double pass = -1.0;
      const ink::SliceReader<T> read = [&](int begin, int end)
      {
        pass += begin == 0 ? 1.0 : 0.0;
        progress(std::min((pass + static_cast<double>(begin) / count) / passes, 1.0));
        return ReadSlices<T>(slabs, begin, end);
      };
      return ink::suggestIsoValues(read, slabs.GetDimensions(), std::max(slabs.GetAtOnce(), 3));
    });
}

ink::FiniteRange InkFindFiniteRange(vtkImageData* image)
{
  return InkWithValues(
    image->GetPointData()->GetScalars(), [](auto values) { return ink::findFiniteRange(values); });
}

ink::FiniteRange InkFindFiniteRange(InkImageSlabs& slabs)
{
  ink::FiniteRange all;
  const int count = slabs.GetDimensions()[2];
  for (int first = 0; first < count; first += slabs.GetAtOnce())
  {
    all.add(InkFindFiniteRange(slabs.Get(first, std::min(first + slabs.GetAtOnce(), count))));
  }
  return all;
}

std::vector<std::size_t> InkBoundLayerPoints(vtkImageData* image, double isoValue, ink::CrossingRule rule)
{
  const std::array<int, 3> d = DimensionsOf(image);
  return InkWithValues(image->GetPointData()->GetScalars(),
    [&](auto values) {
      return ink::boundActiveCells(values, { d[0], d[1], d[2] }, isoValue, rule);
    });
}

std::vector<std::size_t> InkBoundLayerPoints(InkImageSlabs& slabs, double isoValue, ink::CrossingRule rule)
{
  std::vector<std::size_t> layers;
  const int count = slabs.GetDimensions()[2];
  // Parts share a slice.
  for (int first = 0; first + 1 < count; first += slabs.GetAtOnce() - 1)
  {
    const std::vector<std::size_t> counts =
      InkBoundLayerPoints(slabs.Get(first, std::min(first + slabs.GetAtOnce(), count)), isoValue, rule);
    layers.insert(layers.end(), counts.begin(), counts.end());
  }
  return layers;
}

std::string InkDescribe(const ink::IsoSuggestion& suggestion)
{
  using Boundary = ink::IsoSuggestion::Boundary;
  const std::string labels = suggestion.labels == 1
    ? "the edge of a mask"
    : "the edge of all " + std::to_string(suggestion.labels) + " labels";
  const std::string boundary = suggestion.boundary == Boundary::Outermost ? "the outermost clear boundary"
    : suggestion.boundary == Boundary::Inner                              ? "an inner boundary"
    : suggestion.boundary == Boundary::Densest                            ? "the boundary of the densest part"
    : suggestion.boundary == Boundary::Bone                               ? "bone, by its Hounsfield units"
    : suggestion.boundary == Boundary::Labels                             ? labels
    : suggestion.boundary == Boundary::None && suggestion.isLobe
    ? "around the positive values, as those of both signs fade to 0"
    : suggestion.boundary == Boundary::Sign ? "where the sign changes, as no boundary is clear"
                                            : "by Otsu's threshold, as no boundary is clear";
  return boundary + (", keeps " + PercentOf(suggestion)) + " % of the volume";
}

std::vector<std::string> InkDescribeChoice(const std::vector<ink::IsoSuggestion>& suggestions)
{
  std::string text = "iso-value ";
  for (std::size_t i = 0; i < suggestions.size(); ++i)
  {
    text += (i == 0      ? ""
                : i == 1 ? "; next best: "
                         : "; ") +
      ink::formatNumber(suggestions[i].value) + ": " + InkDescribe(suggestions[i]);
  }
  std::vector<std::string> notes{ text };
  if (suggestions.front().boundary == ink::IsoSuggestion::Boundary::None && !suggestions.front().isLobe)
  {
    notes.push_back(
      "no boundary between materials is clear, so what is drawn is the surface around the upper " +
      PercentOf(suggestions.front()) +
      " % of the voxels, and may be that of no thing; other values can be given (IsoValues, --iso), or "
      "voxels stippled without a surface (StippleSource, --stipple-source, in the style stipple)");
  }
  if (suggestions.front().isLobe)
  {
    const std::string value = ink::formatNumber(suggestions.front().value);
    notes.push_back("nothing is drawn of the negative values; IsoValues -" + value + " and " + value +
      " (--iso=-" + value + "," + value + ") draw both");
  }
  return notes;
}
