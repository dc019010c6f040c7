// SPDX-License-Identifier: BSD-3-Clause
#include "InkStyleProcesses.h"

#include "InkSampleCell.h"

#include "vtkAppendPolyData.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <optional>

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

InkWholeImages InkStyleProcesses::GatherImages(std::span<vtkImageData* const> images)
{
  InkWholeImages found;
  for (vtkImageData* image : images)
  {
    if (image->GetPointData()->GetScalars())
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
  // Appending takes none, or that of the first part, which may be empty.
  result->GetFieldData()->Initialize();
  const auto hasPoints = [](vtkPolyData* part) { return part->GetNumberOfPoints() > 0; };
  const auto first = std::find_if(parts.begin(), parts.end(), hasPoints);
  if (first != parts.end())
  {
    result->GetFieldData()->PassData((*first)->GetFieldData());
    const std::optional<glm::dmat3> cell = InkGetSampleCell(*first);
    if (std::any_of(first, parts.end(),
          [&](vtkPolyData* part) { return hasPoints(part) && InkGetSampleCell(part) != cell; }))
    {
      result->GetFieldData()->RemoveArray(InkSampleCellName);
    }
  }
  return result;
}
