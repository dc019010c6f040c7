// SPDX-License-Identifier: BSD-3-Clause
#include "InkPointOutput.h"

#include "Core/ParallelChunks.h"
#include "InkAllocate.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{

template <class RankOf>
vtkSmartPointer<vtkDataArray> MakePriority(std::size_t count, const RankOf& rankOf)
{
  auto priority = vtkSmartPointer<vtkFloatArray>::New();
  priority->SetName("Priority");
  InkSetNumberOfTuples(priority, static_cast<vtkIdType>(count));
  float* values = priority->GetPointer(0);
  const float most = std::nextafter(1.0f, 0.0f);
  ink::parallelForChunks(count,
    [&](std::size_t, std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const double share = static_cast<double>(rankOf(i)) / static_cast<double>(count);
        values[i] = std::min(static_cast<float>(share), most);
      }
    });
  return priority;
}

} // namespace

vtkSmartPointer<vtkCellArray> InkMakePolyVertex(vtkIdType count)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  if (count == 0)
  {
    return cells;
  }
  vtkNew<vtkTypeInt64Array> offsets;
  offsets->SetNumberOfValues(2);
  offsets->SetValue(0, 0);
  offsets->SetValue(1, count);
  vtkNew<vtkTypeInt64Array> points;
  InkSetNumberOfTuples(points, count);
  std::iota(points->GetPointer(0), points->GetPointer(0) + count, vtkTypeInt64(0));
  cells->SetData(offsets, points);
  return cells;
}

vtkSmartPointer<vtkDataArray> InkMakePriority(vtkIdType count)
{
  return MakePriority(static_cast<std::size_t>(count), [](std::size_t i) { return i; });
}

vtkSmartPointer<vtkDataArray> InkMakePriority(std::span<const std::uint32_t> ranks)
{
  return MakePriority(ranks.size(), [&](std::size_t i) { return ranks[i]; });
}

vtkSmartPointer<vtkDataArray> InkMakeConstant(const char* name, int type, vtkIdType count, double value)
{
  vtkSmartPointer<vtkDataArray> array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
  array->SetName(name);
  InkSetNumberOfTuples(array, count);
  array->Fill(value);
  return array;
}
