// SPDX-License-Identifier: BSD-3-Clause
#include "InkIsoSurface.h"

#include "Core/FormatNumber.h"
#include "Fields/Resampling/SliceDistances.h"
#include "InkActiveScalars.h"
#include "InkDistributedParts.h"
#include "InkIsoSurfaceMesh.h"
#include "InkMakeDistances.h"
#include "InkMakeMask.h"
#include "InkStyleProcesses.h"
#include "InkVolumeValues.h"
#include "IsoSurface/ActiveCellComponents.h"
#include "IsoSurface/ResampledSamples.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkInkPrincipalCurvature.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstdint>
#include <optional>

InkIsoSurface::InkIsoSurface()
{
  this->Sampler->SetSmallestPart(ink::ComponentSelection::automatic);
  this->Sampler->GenerateVerticesOff();
}

InkIsoSurface::~InkIsoSurface() = default;

void InkIsoSurface::SetIsoValues(const std::vector<double>& values)
{
  if (this->IsoValues.Give(values))
  {
    this->ValuesChanged.Modified();
  }
}

void InkIsoSurface::SetComputeCurvature(bool compute)
{
  this->Set(this->ComputeCurvature, compute);
}

void InkIsoSurface::SetScalars(const std::string& array)
{
  this->Set(this->Scalars, array);
}

void InkIsoSurface::SetSmallestPart(double share)
{
  this->Sampler->SetSmallestPart(share);
}

double InkIsoSurface::GetSmallestPart() const
{
  return this->Sampler->GetSmallestPart();
}

void InkIsoSurface::SetLargestParts(int count)
{
  this->Sampler->SetLargestParts(count);
}

int InkIsoSurface::GetLargestParts() const
{
  return this->Sampler->GetLargestParts();
}

void InkIsoSurface::SetCut(int cut)
{
  this->Set(this->Cut, cut);
}

void InkIsoSurface::SetSmoothing(double smoothing)
{
  this->Set(this->Smoothing, smoothing);
}

void InkIsoSurface::SetIsoChoice(int choice)
{
  this->Set(this->IsoChoice, choice);
}

void InkIsoSurface::SetLabelMap(int labelMap)
{
  this->Set(this->LabelMap, labelMap);
}

void InkIsoSurface::SetLabelBorders(int borders)
{
  this->Set(this->LabelBorders, borders);
}

void InkIsoSurface::SetSmoothingTarget(int target)
{
  this->Set(this->SmoothingTarget, target);
}

void InkIsoSurface::SetShapeBasedInterpolation(int shapeBased)
{
  this->Set(this->ShapeBasedInterpolation, shapeBased);
}

void InkIsoSurface::SetSubdivision(int subdivision)
{
  this->Set(this->Subdivision, subdivision);
}

void InkIsoSurface::CopyParameters(const InkIsoSurface& other)
{
  this->SetScalars(other.GetScalars());
  this->SetIsoChoice(other.GetIsoChoice());
  this->SetSmallestPart(other.GetSmallestPart());
  this->SetLargestParts(other.GetLargestParts());
  this->SetCut(other.GetCut());
  this->SetSmoothing(other.GetSmoothing());
  this->SetLabelMap(other.GetLabelMap());
  this->SetLabelBorders(other.GetLabelBorders());
  this->SetSmoothingTarget(other.SmoothingTarget);
  this->SetShapeBasedInterpolation(other.GetShapeBasedInterpolation());
  this->SetSubdivision(other.GetSubdivision());
}

ink::SuggestedSmoothing InkIsoSurface::FindSmoothing(
  vtkInkStyle* style, const InkWholeImages& images, const std::vector<double>& values) const
{
  ink::SuggestedSmoothing smoothing;
  for (vtkImageData* image : images)
  {
    for (const double value : values)
    {
      smoothing.add(InkSuggestSmoothing(image, value));
    }
  }
  const auto number = [](bool is) { return is ? 1.0 : 0.0; };
  std::vector<double> numbers{ number(smoothing.labels), number(smoothing.clearBorders),
    number(smoothing.shapeBased) };
  for (const ink::SuggestedDeviations* one : { &smoothing.byValues, &smoothing.byShapes })
  {
    numbers.insert(numbers.end(), { one->ofValues, one->ofLabels, number(one->keepsLabels) });
  }
  style->GetProcesses().TakeOfFirst(numbers);
  return { { numbers[3], numbers[4], numbers[5] > 0.0 }, { numbers[6], numbers[7], numbers[8] > 0.0 },
    numbers[0] > 0.0, numbers[1] > 0.0, numbers[2] > 0.0 };
}

vtkMTimeType InkIsoSurface::GetMTime(bool ofValues)
{
  const vtkMTimeType others = std::max(this->Changed.GetMTime(), this->Sampler->GetMTime());
  return ofValues ? std::max(others, this->ValuesChanged.GetMTime()) : others;
}

std::vector<ink::IsoSuggestion> InkIsoSurface::Suggest(
  vtkInkStyle* style, std::span<vtkImageData* const> images)
{
  return SuggestOf(style, style->GetProcesses().GatherImages(images));
}

void InkIsoSurface::Choose(std::vector<ink::IsoSuggestion>& suggestions) const
{
  if (this->IsoChoice == INNER)
  {
    ink::preferInner(suggestions);
  }
}

std::vector<ink::IsoSuggestion> InkIsoSurface::SuggestOf(vtkInkStyle* style, const InkWholeImages& images)
{
  // Of the largest image that has values to choose from.
  InkWholeImages largestFirst(images);
  std::stable_sort(largestFirst.begin(), largestFirst.end(),
    [](const auto& a, const auto& b) { return a->GetNumberOfPoints() > b->GetNumberOfPoints(); });
  std::vector<ink::IsoSuggestion> suggestions;
  for (std::size_t i = 0; i < largestFirst.size() && suggestions.empty(); ++i)
  {
    suggestions = InkSuggestIsoValues(largestFirst[i]);
  }
  std::vector<double> numbers;
  for (const ink::IsoSuggestion& one : suggestions)
  {
    numbers.insert(numbers.end(),
      { one.value, static_cast<double>(one.boundary), one.keptShare, static_cast<double>(one.labels),
        one.isLobe ? 1.0 : 0.0 });
  }
  style->GetProcesses().TakeOfFirst(numbers);
  suggestions.clear();
  for (std::size_t i = 0; i < numbers.size(); i += 5)
  {
    const auto boundary = static_cast<ink::IsoSuggestion::Boundary>(static_cast<int>(numbers[i + 1]));
    suggestions.push_back({ numbers[i], boundary, numbers[i + 2], static_cast<std::int64_t>(numbers[i + 3]),
      numbers[i + 4] != 0.0 });
  }
  return suggestions;
}

std::string InkIsoSurface::Prepare(vtkInkStyle* style, std::span<vtkImageData* const> images)
{
  std::vector<double> values = this->IsoValues.GetGiven();
  this->IsoValues.Use({});
  // What is automatic is found from the whole, so that it does not show how many processes there are.
  std::optional<InkWholeImages> gathered;
  const Whole whole = [&]() -> const InkWholeImages&
  {
    if (!gathered)
    {
      gathered = style->GetProcesses().GatherImages(images);
    }
    return *gathered;
  };
  if (values.empty())
  {
    std::vector<ink::IsoSuggestion> suggestions = SuggestOf(style, whole());
    if (suggestions.empty())
    {
      return InkIsoValues::None;
    }
    this->Choose(suggestions);
    for (const std::string& note : InkDescribeChoice(suggestions))
    {
      style->AddNote(note);
    }
    values.push_back(suggestions.front().value);
  }
  this->IsoValues.Use(values);
  vtkInkIsoSurfaceSampler* sampler = this->Sampler;
  sampler->SetValues(values);
  ink::SuggestedSmoothing suggested;
  const auto hasThickSlices = [&]
  {
    std::array has = { std::any_of(images.begin(), images.end(), HasThickSlices) ? 1.0 : 0.0 };
    style->GetProcesses().TakeGreatest(has);
    return has[0] > 0.0;
  };
  if (this->AsksForSuggestion(hasThickSlices))
  {
    suggested = this->FindSmoothing(style, whole(), values);
  }
  const bool labels = this->TakeLabels(
    sampler, suggested, [] { return true; },
    [&, least = *std::min_element(values.begin(), values.end())](bool ofLabels)
    {
      std::vector<double> isSolid = { static_cast<double>(std::all_of(whole().begin(), whole().end(),
        [&](const auto& image)
        { return (ofLabels || IsSlab(image)) && !InkSurroundsObject(image, least); })) };
      // Only the first process has gathered images.
      style->GetProcesses().TakeOfFirst(isSolid);
      return isSolid[0] > 0.0;
    });
  sampler->SetSmoothing(this->Smoothing < 0.0
      ? suggested.get(sampler->GetShapeBasedInterpolation()).get(labels)
      : this->Smoothing);
  sampler->SetSubdivision(this->FindSubdivision(style, images, whole, values));
  return {};
}

bool InkIsoSurface::IsSlab(vtkImageData* image)
{
  constexpr double flat = 0.5;
  const int* dimensions = image->GetDimensions();
  const double* spacing = image->GetSpacing();
  std::array<double, 3> sizes;
  for (std::size_t axis = 0; axis < sizes.size(); ++axis)
  {
    sizes[axis] = std::abs(spacing[axis]) * dimensions[axis];
  }
  std::sort(sizes.begin(), sizes.end());
  return sizes[0] < flat * sizes[1];
}

bool InkIsoSurface::HasThickSlices(vtkImageData* frame)
{
  const double* spacing = frame->GetSpacing();
  return ink::thickSlices({ spacing[0], spacing[1], spacing[2] }).has_value();
}

bool InkIsoSurface::AsksForSuggestion(const std::function<bool()>& hasThickSlices) const
{
  return this->Smoothing < 0.0 || this->LabelMap == LABELS_AUTOMATIC ||
    (this->LabelMap == LABELS_ON && this->LabelBorders == BORDERS_AUTOMATIC) ||
    (this->ShapeBasedInterpolation == SHAPES_AUTOMATIC && hasThickSlices());
}

bool InkIsoSurface::TakeLabels(vtkInkIsoSurfaceAlgorithm* sampler, const ink::SuggestedSmoothing& suggested,
  const std::function<bool()>& hasRoomForShapes, const std::function<bool(bool labels)>& isSolid) const
{
  const bool labels = this->LabelMap == LABELS_ON || (this->LabelMap == LABELS_AUTOMATIC && suggested.labels);
  sampler->SetLabelMap(labels);
  sampler->SetShapeBasedInterpolation(this->ShapeBasedInterpolation == SHAPES_AUTOMATIC
      ? suggested.shapeBased || labels
      : this->ShapeBasedInterpolation == SHAPES_ON);
  if (this->ShapeBasedInterpolation == SHAPES_AUTOMATIC && !hasRoomForShapes())
  {
    sampler->ShapeBasedInterpolationOff();
  }
  // With normals, thin parts stay.
  const bool smoothsSurface = labels && suggested.get(sampler->GetShapeBasedInterpolation()).keepsLabels;
  sampler->SetLabelBorders(this->LabelBorders == BORDERS_AUTOMATIC ? labels && suggested.clearBorders
                                                                   : this->LabelBorders == BORDERS_ON);
  sampler->SetSmoothingTarget(this->SmoothingTarget != TARGET_AUTOMATIC ? this->SmoothingTarget
      : smoothsSurface                                                  ? vtkInkIsoSurfaceAlgorithm::SURFACE
                                                                        : vtkInkIsoSurfaceAlgorithm::NORMALS);
  sampler->SetCut(this->Cut != CUT_AUTOMATIC ? this->Cut
      : isSolid(labels)                      ? vtkInkIsoSurfaceAlgorithm::CAP
                                             : vtkInkIsoSurfaceAlgorithm::RIM);
  return labels;
}

double InkIsoSurface::ChooseSmoothing(vtkInkStyle* style, std::span<vtkImageData* const> images) const
{
  if (this->Smoothing >= 0.0)
  {
    return this->Smoothing;
  }
  const InkWholeImages whole = style->GetProcesses().GatherImages(images);
  std::vector<ink::IsoSuggestion> suggestions = SuggestOf(style, whole);
  this->Choose(suggestions);
  return suggestions.empty()
    ? 0.0
    : this->FindSmoothing(style, whole, { suggestions.front().value }).byValues.ofValues;
}

std::string InkIsoSurface::Sample(
  vtkInkStyle* style, const vtkInkStyle::Input& input, vtkImageData* image, vtkPolyData* points)
{
  vtkInkIsoSurfaceSampler* sampler = this->Sampler;
  // Of an image that has values in its cells, `image` is made.
  const bool part = input.Port && vtkImageData::SafeDownCast(input.Data);
  InkSelectScalars(sampler, part ? this->Scalars : std::string());
  if (part)
  {
    sampler->SetInputConnection(input.Port);
  }
  else
  {
    sampler->SetInputData(image);
  }
  // Parts that go on in other processes are judged by KeepParts.
  const ink::ComponentSelection selection = this->GetSelection();
  const bool judgesLater = part && style->GetProcesses().GetNumber() > 1 && !selection.keepsAll();
  sampler->SetComputeCellIds(judgesLater);
  if (judgesLater)
  {
    sampler->SetSmallestPart(0.0);
    sampler->SetLargestParts(0);
  }
  vtkNew<vtkInformation> whole;
  vtkInformation* request = part && input.Request ? input.Request : whole.Get();
  const std::string problem =
    style->Follow(sampler, "sampling the surface", [&] { sampler->Update(request); });
  // The sampler's own output is another image's when it is asked again.
  points->ShallowCopy(sampler->GetOutput());
  style->SetFramePoints(points->GetPoints());
  sampler->SetInputConnection(nullptr);
  sampler->SetSmallestPart(selection.smallestShare);
  sampler->SetLargestParts(static_cast<int>(selection.largest));
  if (problem.empty() && !input.Port)
  {
    this->NoteWhereEmpty(style, points);
  }
  return problem;
}

void InkIsoSurface::TakeFrame(
  vtkInkStyle* style, const vtkInkStyle::Input& input, std::span<vtkImageData* const> images, bool isPrepared)
{
  if (input.Port)
  {
    return;
  }
  const std::vector<std::string> notes = style->Notes;
  std::vector<vtkSmartPointer<vtkPolyData>> parts;
  if (isPrepared || this->Prepare(style, images).empty())
  {
    for (vtkImageData* image : images)
    {
      parts.push_back(vtkSmartPointer<vtkPolyData>::New());
      this->Sample(style, input, image, parts.back());
    }
  }
  style->Notes = notes;
  const vtkSmartPointer<vtkPolyData> all = parts.empty() ? nullptr : InkAppend(parts);
  style->SetFramePoints(all && all->GetNumberOfPoints() > 0 ? all->GetPoints() : nullptr);
}

ink::ComponentSelection InkIsoSurface::GetSelection() const
{
  return { this->GetSmallestPart(), static_cast<std::size_t>(this->GetLargestParts()) };
}

void InkIsoSurface::KeepParts(
  vtkInkStyle* style, const vtkInkStyle::Input& input, std::span<const vtkSmartPointer<vtkPolyData>> points)
{
  const ink::ComponentSelection selection =
    this->GetSelection().inDividedCells(this->Sampler->GetSubdivision());
  if (!input.Port || style->GetProcesses().GetNumber() < 2 || selection.keepsAll())
  {
    return;
  }
  // A process has a part of one image, or whole images, whose parts were judged then.
  vtkPolyData* own = points.size() == 1 ? points.front().Get() : nullptr;
  InkKeepPartsOfAll(
    style->GetProcesses(), selection, static_cast<int>(this->Sampler->GetNumberOfContours()), own);
  if (own)
  {
    style->SetFramePoints(own->GetPoints());
  }
}

std::string InkIsoSurface::Mesh(vtkInkStyle* style, vtkImageData* image, vtkPolyData* mesh)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const std::optional<ink::ThickSlices> slices = this->Sampler->FindThickSlices(image);
  if (!this->Sampler->GetLabelMap() && !slices)
  {
    return this->MeshOf(style, image, scalars, this->Sampler, mesh);
  }
  // Each iso-value has a mask, or distances, of its own.
  std::vector<vtkSmartPointer<vtkPolyData>> parts;
  vtkNew<vtkInkIsoSurfaceSampler> settings;
  settings->CopyProperties(this->Sampler);
  for (int n = 0; n < this->Sampler->GetNumberOfContours(); ++n)
  {
    vtkSmartPointer<vtkDataArray> values;
    double isoValue = this->Sampler->GetValue(n);
    if (slices)
    {
      values = InkMakeDistances(image, scalars, isoValue, this->Sampler->GetLabelMap(), *slices);
      isoValue = 0.0;
    }
    else
    {
      values = InkMakeMask(scalars, isoValue);
      isoValue = ink::maskIsoValue;
    }
    settings->SetValue(0, isoValue);
    parts.push_back(vtkSmartPointer<vtkPolyData>::New());
    const std::string problem = this->MeshOf(style, image, values, settings, parts.back());
    if (!problem.empty())
    {
      return problem;
    }
  }
  if (!parts.empty())
  {
    mesh->ShallowCopy(InkAppend(parts));
  }
  return {};
}

std::string InkIsoSurface::MeshOf(vtkInkStyle* style, vtkImageData* image, vtkDataArray* scalars,
  vtkInkIsoSurfaceSampler* settings, vtkPolyData* mesh) const
{
  const std::string problem = InkMakeIsoSurfaceMesh(
    image, scalars, settings,
    [style](vtkAlgorithm* algorithm) { return style->Follow(algorithm, "meshing the surface"); }, mesh);
  const bool adds = this->ComputeCurvature && problem.empty() && mesh->GetNumberOfPoints() > 0;
  return adds ? this->AddCurvature(style, image, scalars, mesh) : problem;
}

std::string InkIsoSurface::AddCurvature(
  vtkInkStyle* style, vtkImageData* image, vtkDataArray* scalars, vtkPolyData* mesh) const
{
  vtkNew<vtkImageData> field;
  field->ShallowCopy(image);
  field->GetPointData()->SetScalars(scalars);
  vtkNew<vtkInkPrincipalCurvature> curvature;
  curvature->SetInputData(mesh);
  curvature->SetFieldData(field);
  // What smooths the surface smooths its curvature; less than the default shows noise.
  curvature->SetFieldSmoothing(std::max(curvature->GetFieldSmoothing(), this->Sampler->GetSmoothing()));
  const std::string problem = style->Follow(curvature, "finding the surface's curvature");
  if (problem.empty())
  {
    mesh->ShallowCopy(curvature->GetOutput());
  }
  return problem;
}

void InkIsoSurface::NoteWhereEmpty(vtkInkStyle* style, vtkPolyData* surface)
{
  if (surface->GetNumberOfPoints() == 0)
  {
    style->AddNote(
      "nothing to draw: no surface at iso-value " + ink::formatNumber(this->Sampler->GetValue(0)));
  }
}
