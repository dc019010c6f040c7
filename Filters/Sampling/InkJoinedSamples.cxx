// SPDX-License-Identifier: BSD-3-Clause
#include "InkJoinedSamples.h"

#include "InkPointOutput.h"
#include "InkSurfaceParts.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <stdexcept>
#include <string>

namespace
{

constexpr const char* CellIds = "CellId";

/// The coordinates, and then the arrays.
std::vector<vtkDataArray*> ArraysOf(vtkPolyData* points)
{
  std::vector<vtkDataArray*> arrays{ points->GetPoints()->GetData() };
  for (int i = 0; i < points->GetPointData()->GetNumberOfArrays(); ++i)
  {
    arrays.push_back(points->GetPointData()->GetArray(i));
  }
  return arrays;
}

/// As many tuples as `source` has, behind those before. @return the end of them
unsigned char* Append(vtkDataArray* source, unsigned char* to)
{
  const auto bytes = static_cast<std::size_t>(source->GetNumberOfValues()) *
    static_cast<std::size_t>(source->GetDataTypeSize());
  std::memcpy(to, source->GetVoidPointer(0), bytes);
  return to + bytes;
}

} // namespace

InkJoinedSamples::InkJoinedSamples(const InkMemoryBudget& budget)
  : Budget(budget)
{
}

void InkJoinedSamples::Add(int surface, vtkPolyData* points)
{
  const auto count = static_cast<std::uint64_t>(points->GetNumberOfPoints());
  if (count == 0)
  {
    return;
  }
  this->Total += count;
  if (this->Total * InkBytesPerPoint > this->Budget.Limit)
  {
    throw std::runtime_error("the surface has " + std::to_string(this->Total) +
      " points or more, which take " + InkFormatMemory(this->Total * InkBytesPerPoint) +
      ": expected MaximumMemory of more than that, found " + InkFormatMemory(this->Budget.Limit));
  }
  const auto index = static_cast<std::size_t>(surface);
  this->Counts.resize(std::max(this->Counts.size(), index + 1));
  this->Parts.resize(this->Counts.size());
  this->Counts[index] += static_cast<std::size_t>(count);
  this->Parts[index].emplace_back(vtkSmartPointer<vtkPolyData>::New());
  this->Parts[index].back()->ShallowCopy(points);
}

void InkJoinedSamples::Fill(
  vtkPolyData* output, const ink::ComponentSelection& selection, const Contents& contents) const
{
  output->Initialize();
  if (this->Total == 0)
  {
    return;
  }
  this->FillAll(output);
  vtkPointData* data = output->GetPointData();
  std::vector<std::size_t> counts = this->Counts;
  if (!selection.keepsAll())
  {
    const std::vector<vtkDataArray*> arrays = ArraysOf(output);
    vtkDataArray* ids = data->GetArray(CellIds);
    const auto* cells = static_cast<const ink::ActiveCellId*>(ids->GetVoidPointer(0));
    InkKeepParts({ cells, static_cast<std::size_t>(ids->GetNumberOfValues()) }, selection, arrays, counts);
    const auto left = std::accumulate(counts.begin(), counts.end(), std::size_t{ 0 });
    for (vtkDataArray* array : arrays)
    {
      array->SetNumberOfTuples(static_cast<vtkIdType>(left));
    }
  }
  if (!contents.CellIds)
  {
    data->RemoveArray(CellIds);
  }
  if (contents.SurfaceIndex)
  {
    data->AddArray(InkMakeSurfaceIndex(counts));
  }
  if (contents.Vertices)
  {
    output->SetVerts(InkMakePolyVertex(output->GetNumberOfPoints()));
  }
}

void InkJoinedSamples::FillAll(vtkPolyData* output) const
{
  std::vector<vtkPolyData*> all;
  for (const auto& ofSurface : this->Parts)
  {
    all.insert(all.end(), ofSurface.begin(), ofSurface.end());
  }
  if (all.size() == 1)
  {
    output->ShallowCopy(all.front());
    return;
  }
  const std::vector<vtkDataArray*> first = ArraysOf(all.front());
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    vtkSmartPointer<vtkDataArray> array = vtk::TakeSmartPointer(first[i]->NewInstance());
    array->SetName(first[i]->GetName());
    array->SetNumberOfComponents(first[i]->GetNumberOfComponents());
    array->SetNumberOfTuples(static_cast<vtkIdType>(this->Total));
    auto* to = static_cast<unsigned char*>(array->GetVoidPointer(0));
    for (vtkPolyData* part : all)
    {
      to = Append(ArraysOf(part)[i], to);
    }
    if (i == 0)
    {
      vtkNew<vtkPoints> points;
      points->SetData(array);
      output->SetPoints(points);
    }
    else
    {
      output->GetPointData()->AddArray(array);
    }
  }
  output->GetPointData()->SetActiveNormals("Normals");
  output->SetFieldData(all.front()->GetFieldData());
}
