// SPDX-License-Identifier: BSD-3-Clause
#include "InkDistributedParts.h"

#include "InkExtractPoints.h"
#include "InkStyleProcesses.h"
#include "InkSurfaceParts.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
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
    vtkNew<vtkPolyData> left;
    InkExtractPoints(points, kept, left);
    left->GetPointData()->RemoveArray(CellIds);
    left->GetPointData()->RemoveArray(Surfaces);
    points->ShallowCopy(left);
  }
}
