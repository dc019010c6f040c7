// SPDX-License-Identifier: BSD-3-Clause
#include "InkStyleProcesses.h"

#include "InkVolumeValues.h"

#include "vtkAppendPolyData.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

InkStyleProcesses::~InkStyleProcesses() = default;

void InkStyleProcesses::TakeGreatest(std::span<double>) {}

void InkStyleProcesses::TakeOfFirst(std::vector<double>&) {}

std::vector<std::int64_t> InkStyleProcesses::GatherAll(std::span<const std::int64_t> own, std::size_t& begin)
{
  begin = 0;
  return { own.begin(), own.end() };
}

void InkStyleProcesses::AddUp(ink::stipple::VolumeStatistics&) {}

vtkSmartPointer<vtkPolyData> InkStyleProcesses::Gather(const std::vector<vtkSmartPointer<vtkPolyData>>& parts)
{
  return InkAppend(parts);
}

InkWholeImages InkStyleProcesses::GatherImages(
  std::span<vtkImageData* const> images, const std::string& array)
{
  InkWholeImages found;
  for (vtkImageData* image : images)
  {
    if (InkFindScalars(image, array))
    {
      found.push_back(image);
    }
  }
  return found;
}

void InkStyleProcesses::AgreeOnArray(std::string&, int&) {}

vtkSmartPointer<vtkPolyData> InkAppend(const std::vector<vtkSmartPointer<vtkPolyData>>& parts)
{
  if (parts.size() < 2)
  {
    return parts.empty() ? vtkSmartPointer<vtkPolyData>::New() : parts.front();
  }
  vtkNew<vtkAppendPolyData> append;
  for (const auto& part : parts)
  {
    append->AddInputData(part);
  }
  append->Update();
  vtkSmartPointer<vtkPolyData> result = append->GetOutput();
  // Of all parts alike, but appending leaves it out.
  result->GetFieldData()->PassData(parts.front()->GetFieldData());
  return result;
}
