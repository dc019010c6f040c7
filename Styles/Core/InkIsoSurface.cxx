// SPDX-License-Identifier: BSD-3-Clause
#include "InkIsoSurface.h"

#include "InkVolumeValues.h"
#include "vtkInkIsoSurfaceSampler.h"

#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPolyData.h"

#include <algorithm>

InkIsoSurface::InkIsoSurface()
{
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

vtkMTimeType InkIsoSurface::GetMTime()
{
  return std::max(this->Changed.GetMTime(), this->Sampler->GetMTime());
}

std::string InkIsoSurface::Sample(vtkInkStyle* style, const vtkInkStyle::Input& input, vtkImageData* image,
  const std::string& array, vtkPolyData* points)
{
  const bool part = input.Port && input.Data == image;
  std::vector<double> values = this->IsoValues;
  if (values.empty())
  {
    // Processes that hold parts would each choose another one.
    const auto chosen = input.Port ? std::nullopt : style->ChooseIsoValue(image, array);
    if (!chosen)
    {
      return input.Port ? "expected an iso-value, found none"
                        : "expected an image with two different finite values or more, found none";
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
  sampler->SetInputConnection(nullptr);
  if (problem.empty() && !input.Port && points->GetNumberOfPoints() == 0)
  {
    style->AddNote("nothing to draw: no surface at iso-value " + InkFormatShort(values.front()));
  }
  return problem;
}
