// SPDX-License-Identifier: BSD-3-Clause
#include "InkIsoSurface.h"

#include "InkStyleProcesses.h"
#include "InkVolumeValues.h"
#include "IsoSurface/ActiveCellComponents.h"
#include "vtkInkIsoSurfaceSampler.h"

#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace
{

/// Cells are divided until they measure no more pixels than this on either side, but not into more.
constexpr double MostPixelsPerCell = 4.0;
constexpr int MostSubdivision = 8;
/// While someone changes the picture's size, what is divided stays so until its cells are smaller than this.
constexpr double LeastPixelsPerCell = 1.5;

} // namespace

InkIsoSurface::InkIsoSurface()
{
  // Thin parts stay.
  this->Sampler->SetSmoothingTargetToNormals();
  this->Sampler->SetCutToRim();
  this->Sampler->SetSmallestPart(ink::ComponentSelection::automatic);
  this->Sampler->GenerateVerticesOff();
}

InkIsoSurface::~InkIsoSurface() = default;

void InkIsoSurface::SetIsoValues(const std::vector<double>& values)
{
  if (this->IsoValues != values)
  {
    this->IsoValues = values;
    this->Changed.Modified();
  }
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
  this->Sampler->SetCut(cut);
}

int InkIsoSurface::GetCut() const
{
  return this->Sampler->GetCut();
}

void InkIsoSurface::SetSmoothing(double smoothing)
{
  if (this->Smoothing != smoothing)
  {
    this->Smoothing = smoothing;
    this->Changed.Modified();
  }
}

void InkIsoSurface::SetSmoothingTarget(int target)
{
  this->Sampler->SetSmoothingTarget(target);
}

int InkIsoSurface::GetSmoothingTarget() const
{
  return this->Sampler->GetSmoothingTarget();
}

void InkIsoSurface::SetSubdivision(int subdivision)
{
  if (this->Subdivision != subdivision)
  {
    this->Subdivision = subdivision;
    this->Changed.Modified();
  }
}

double InkIsoSurface::FindSmoothing(vtkInkStyle* style, std::span<vtkImageData* const> images,
  const std::string& array, const std::vector<double>& values) const
{
  if (this->Smoothing >= 0.0)
  {
    return this->Smoothing;
  }
  double smoothing = 0.0;
  for (vtkImageData* image : images)
  {
    for (const double value : values)
    {
      smoothing = std::max(smoothing, InkSuggestSmoothing(image, array, value));
    }
  }
  style->GetProcesses().TakeGreatest({ &smoothing, 1 });
  return smoothing;
}

int InkIsoSurface::FindSubdivision(vtkInkStyle* style, std::span<vtkImageData* const> images) const
{
  if (this->Subdivision > 0)
  {
    return this->Subdivision;
  }
  // Of all images of all processes, the lower corner, negated, the upper one, and the finest spacing,
  // negated.
  std::array<double, 7> most;
  most.fill(std::numeric_limits<double>::lowest());
  for (vtkImageData* image : images)
  {
    const double* box = image->GetBounds();
    const double* spacing = image->GetSpacing();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      most[axis] = std::max(most[axis], -box[2 * axis]);
      most[3 + axis] = std::max(most[3 + axis], box[2 * axis + 1]);
      most[6] = std::max(most[6], -std::abs(spacing[axis]));
    }
  }
  style->GetProcesses().TakeGreatest(most);
  const double longest = std::max({ most[0] + most[3], most[1] + most[4], most[2] + most[5] });
  const double pixels = longest > 0.0 ? style->GetPictureSize() * -most[6] / longest : 0.0;
  // The sampler's, from the last time.
  int subdivision = style->GetInteractive() ? this->Sampler->GetSubdivision() : 1;
  while (subdivision < MostSubdivision && pixels > MostPixelsPerCell * subdivision)
  {
    subdivision *= 2;
  }
  while (subdivision > 1 && pixels < LeastPixelsPerCell * subdivision)
  {
    subdivision /= 2;
  }
  return subdivision;
}

vtkMTimeType InkIsoSurface::GetMTime()
{
  return std::max(this->Changed.GetMTime(), this->Sampler->GetMTime());
}

std::optional<double> InkIsoSurface::ChooseValue(
  vtkInkStyle* style, std::span<vtkImageData* const> images, const std::string& array)
{
  // Of the largest image that has values to choose from.
  std::vector<vtkImageData*> largestFirst(images.begin(), images.end());
  std::stable_sort(largestFirst.begin(), largestFirst.end(),
    [](vtkImageData* a, vtkImageData* b) { return a->GetNumberOfPoints() > b->GetNumberOfPoints(); });
  std::optional<double> own;
  double voxels = 0.0;
  for (std::size_t i = 0; i < largestFirst.size() && !own; ++i)
  {
    own = style->ChooseIsoValue(largestFirst[i], array);
    voxels = own ? static_cast<double>(largestFirst[i]->GetNumberOfPoints()) : 0.0;
  }
  double most = voxels;
  style->GetProcesses().TakeGreatest({ &most, 1 });
  double value = own && voxels == most ? *own : std::numeric_limits<double>::lowest();
  style->GetProcesses().TakeGreatest({ &value, 1 });
  return most > 0.0 ? std::optional(value) : std::nullopt;
}

std::string InkIsoSurface::Prepare(
  vtkInkStyle* style, std::span<vtkImageData* const> images, const std::string& array)
{
  std::vector<double> values = this->IsoValues;
  if (values.empty())
  {
    const auto chosen = ChooseValue(style, images, array);
    if (!chosen)
    {
      return "expected an image with two different finite values or more, found none";
    }
    values.push_back(*chosen);
  }
  vtkInkIsoSurfaceSampler* sampler = this->Sampler;
  if (array.empty())
  {
    sampler->SetInputArrayToProcess(
      0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  }
  else
  {
    sampler->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array.c_str());
  }
  sampler->SetNumberOfContours(static_cast<int>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    sampler->SetValue(static_cast<int>(i), values[i]);
  }
  sampler->SetSmoothing(this->FindSmoothing(style, images, array, values));
  sampler->SetSubdivision(this->FindSubdivision(style, images));
  return {};
}

std::string InkIsoSurface::Sample(
  vtkInkStyle* style, const vtkInkStyle::Input& input, vtkImageData* image, vtkPolyData* points)
{
  vtkInkIsoSurfaceSampler* sampler = this->Sampler;
  const bool part = input.Port && input.Data == image;
  if (part)
  {
    sampler->SetInputConnection(input.Port);
  }
  else
  {
    sampler->SetInputData(image);
  }
  vtkNew<vtkInformation> whole;
  vtkInformation* request = part && input.Request ? input.Request : whole.Get();
  const std::string problem =
    style->Follow(sampler, "sampling the surface", [&] { sampler->Update(request); });
  // The sampler's own output is another image's when it is asked again.
  points->ShallowCopy(sampler->GetOutput());
  style->SetFramePoints(points->GetPoints());
  sampler->SetInputConnection(nullptr);
  if (problem.empty() && !input.Port && points->GetNumberOfPoints() == 0)
  {
    style->AddNote("nothing to draw: no surface at iso-value " + InkFormatShort(sampler->GetValue(0)));
  }
  return problem;
}
