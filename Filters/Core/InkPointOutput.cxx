// SPDX-License-Identifier: BSD-3-Clause
#include "InkPointOutput.h"

#include "Core/ParallelChunks.h"
#include "InkAllocate.h"
#include "InkTrimArray.h"
#include "InkVTKCompat.h"
#include "IsoSurface/CutSamples.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <tuple>

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
  ink::parallelForEach(count,
    [&](std::size_t i)
    {
      const double share = static_cast<double>(rankOf(i)) / static_cast<double>(count);
      values[i] = std::min(static_cast<float>(share), most);
    });
  return priority;
}

template <class Array>
void NarrowRims(Array* points, vtkDataArray* radii)
{
  const auto* coordinates = points->GetPointer(0);
  auto* radius = Array::FastDownCast(radii)->GetPointer(0);
  constexpr std::size_t outer = ink::rimOuterNormals;
  const auto at = [coordinates](std::size_t i)
  { return std::tuple(coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]); };
  ink::parallelForEach(static_cast<std::size_t>(points->GetNumberOfTuples()),
    [&](std::size_t i)
    {
      if (i >= outer && at(i) == at(i - outer))
      {
        radius[i] /= 2;
      }
    });
}

vtkSmartPointer<vtkDataArray> MakeIds(vtkIdType count)
{
  return vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(InkFindIdType(count)));
}

template <class IdArray>
vtkSmartPointer<vtkCellArray> MakePolyVertices(std::span<const vtkIdType> begins, IdArray* ids)
{
  using Id = typename IdArray::ValueType;
  vtkNew<IdArray> offsets;
  InkSetNumberOfTuples(offsets, static_cast<vtkIdType>(begins.size()));
  std::transform(
    begins.begin(), begins.end(), offsets->GetPointer(0), [](vtkIdType id) { return static_cast<Id>(id); });
  InkSetNumberOfTuples(ids, begins.back());
  InkTrimArray(ids);
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + begins.back(), Id(0));
  ids->Modified();
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, ids);
  return cells;
}

vtkSmartPointer<vtkCellArray> MakePolyVertices(std::span<const vtkIdType> begins, vtkDataArray* ids)
{
  auto* small = vtkTypeInt32Array::SafeDownCast(ids);
  return small ? MakePolyVertices(begins, small)
               : MakePolyVertices(begins, vtkTypeInt64Array::SafeDownCast(ids));
}

} // namespace

void InkNarrowRims(vtkPoints* points, vtkDataArray* radii)
{
  if (auto* floats = vtkFloatArray::FastDownCast(points->GetData()))
  {
    NarrowRims(floats, radii);
  }
  else
  {
    NarrowRims(vtkDoubleArray::FastDownCast(points->GetData()), radii);
  }
}

int InkFindIdType(vtkIdType count)
{
  return count <= std::numeric_limits<vtkTypeInt32>::max() ? VTK_TYPE_INT32 : VTK_TYPE_INT64;
}

vtkSmartPointer<vtkCellArray> InkMakePolyVertices(std::span<const vtkIdType> begins)
{
  return MakePolyVertices(begins, MakeIds(begins.back()));
}

vtkSmartPointer<vtkCellArray> InkMakePolyVertex(vtkIdType count)
{
  return InkMakePolyVertex(count, MakeIds(count));
}

vtkSmartPointer<vtkCellArray> InkMakePolyVertex(vtkIdType count, vtkDataArray* ids)
{
  const vtkIdType begins[] = { 0, count };
  return count > 0 ? MakePolyVertices(begins, ids) : vtkSmartPointer<vtkCellArray>::New();
}

vtkSmartPointer<vtkDataArray> InkMakePriority(vtkIdType count)
{
  return MakePriority(static_cast<std::size_t>(count), [](std::size_t i) { return i; });
}

vtkSmartPointer<vtkDataArray> InkMakePriority(std::span<const std::uint32_t> ranks)
{
  return MakePriority(ranks.size(), [&](std::size_t i) { return ranks[i]; });
}

vtkSmartPointer<vtkDataArray> InkMakeSurfaceIndex(std::span<const std::size_t> counts)
{
  auto index = vtkSmartPointer<vtkIntArray>::New();
  index->SetName("SurfaceIndex");
  InkSetNumberOfTuples(
    index, static_cast<vtkIdType>(std::accumulate(counts.begin(), counts.end(), std::size_t(0))));
  int* next = index->GetPointer(0);
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    next = std::fill_n(next, counts[i], static_cast<int>(i));
  }
  return index;
}

vtkSmartPointer<vtkDataArray> InkMakeConstant(const char* name, int type, vtkIdType count, double value)
{
  vtkSmartPointer<vtkDataArray> array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
  array->SetName(name);
  InkSetNumberOfTuples(array, count);
  array->Fill(value);
  return array;
}
