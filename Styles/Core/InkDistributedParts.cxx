// SPDX-License-Identifier: BSD-3-Clause
#include "InkDistributedParts.h"

#include "InkStyleProcesses.h"
#include "InkSurfaceParts.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace
{

constexpr const char* CellIds = "CellId";
constexpr const char* Surfaces = "SurfaceIndex";

/// The points of one surface.
std::vector<std::uint32_t> PointsOf(vtkPolyData* points, int surface)
{
  std::vector<std::uint32_t> ids;
  vtkDataArray* index = points->GetPointData()->GetArray(Surfaces);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    if (!index || static_cast<int>(index->GetComponent(i, 0)) == surface)
    {
      ids.push_back(static_cast<std::uint32_t>(i));
    }
  }
  return ids;
}

/// Leaves points of these ids, with all their arrays.
void KeepPoints(vtkPolyData* points, const std::vector<std::uint32_t>& ids)
{
  const auto count = static_cast<vtkIdType>(ids.size());
  vtkNew<vtkIdList> from;
  vtkNew<vtkIdList> to;
  from->SetNumberOfIds(count);
  to->SetNumberOfIds(count);
  std::copy(ids.begin(), ids.end(), from->GetPointer(0));
  std::iota(to->GetPointer(0), to->GetPointer(0) + count, vtkIdType(0));
  vtkNew<vtkPolyData> left;
  vtkNew<vtkPoints> positions;
  positions->SetDataType(points->GetPoints()->GetDataType());
  positions->SetNumberOfPoints(count);
  points->GetPoints()->GetPoints(from, positions);
  left->SetPoints(positions);
  vtkPointData* data = left->GetPointData();
  data->CopyAllOn();
  data->CopyAllocate(points->GetPointData(), count);
  data->CopyData(points->GetPointData(), from, to);
  data->RemoveArray(CellIds);
  data->RemoveArray(Surfaces);
  left->GetFieldData()->PassData(points->GetFieldData());
  points->ShallowCopy(left);
}

} // namespace

void InkKeepPartsOfAll(
  InkStyleProcesses& processes, const ink::ComponentSelection& selection, int surfaces, vtkPolyData* points)
{
  auto* cells = points ? vtkTypeInt64Array::SafeDownCast(points->GetPointData()->GetArray(CellIds)) : nullptr;
  std::vector<std::uint32_t> kept;
  for (int surface = 0; surface < surfaces; ++surface)
  {
    const std::vector<std::uint32_t> ids = cells ? PointsOf(points, surface) : std::vector<std::uint32_t>();
    std::vector<std::int64_t> own;
    for (const std::uint32_t id : ids)
    {
      own.push_back(cells->GetValue(id));
    }
    std::size_t begin = 0;
    const std::vector<std::int64_t> all = processes.GatherAll(own, begin);
    // The numbers of all points, of which those that stay are left.
    vtkNew<vtkTypeInt64Array> numbers;
    numbers->SetNumberOfValues(static_cast<vtkIdType>(all.size()));
    vtkTypeInt64* first = numbers->GetPointer(0);
    std::iota(first, first + all.size(), vtkTypeInt64{ 0 });
    std::vector<std::size_t> counts{ all.size() };
    vtkDataArray* const arrays[] = { numbers };
    InkKeepParts(all, selection, arrays, counts);
    std::for_each(first, first + counts[0],
      [&](vtkTypeInt64 number)
      {
        const auto i = static_cast<std::size_t>(number);
        if (i >= begin && i - begin < ids.size())
        {
          kept.push_back(ids[i - begin]);
        }
      });
  }
  if (cells)
  {
    KeepPoints(points, kept);
  }
}
