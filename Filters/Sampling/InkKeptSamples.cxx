// SPDX-License-Identifier: BSD-3-Clause
#include "InkKeptSamples.h"

#include "InkAllocate.h"
#include "InkPointOutput.h"
#include "InkTrimArray.h"
#include "InkVTKCompat.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkShortArray.h"
#include "vtkSignedCharArray.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace
{

/// The kept array if nobody else references it and it has the right type, otherwise a new one.
vtkDataArray* RenewArray(vtkSmartPointer<vtkDataArray>& array, int type, int components)
{
  if (!array || array->GetReferenceCount() > 1 || array->GetDataType() != type ||
    array->GetNumberOfComponents() != components)
  {
    array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
    array->SetNumberOfComponents(components);
  }
  return array;
}

template <class T, class Array>
T* PointerTo(vtkDataArray* array)
{
  auto* typed = Array::SafeDownCast(array);
  return typed ? typed->GetPointer(0) : nullptr;
}

} // namespace

InkSampleArrays InkKeptSamples::Renew(int pointType, int normalType, bool cells)
{
  if (!this->Points || this->Points->GetReferenceCount() > 1 || this->Points->GetDataType() != pointType ||
    this->Points->GetData()->GetReferenceCount() > 1)
  {
    this->Points = vtkSmartPointer<vtkPoints>::New();
    this->Points->SetDataType(pointType);
  }
  return { this->Points->GetData(),
    normalType != VTK_VOID ? RenewArray(this->Normals, normalType, 3) : nullptr,
    cells ? RenewArray(this->CellIds, VTK_TYPE_INT64, 1) : nullptr };
}

ink::SampleRoom InkKeptSamples::Grow(const InkSampleArrays& arrays, std::size_t count)
{
  vtkIdType capacity = VTK_ID_MAX;
  for (vtkDataArray* array : arrays.All())
  {
    InkReserve(array, static_cast<vtkIdType>(count));
    capacity = std::min(capacity, InkGetCapacity(array) / array->GetNumberOfComponents());
  }
  ink::SampleRoom room;
  room.capacity = static_cast<std::size_t>(capacity);
  room.points = PointerTo<float, vtkFloatArray>(arrays.Points);
  room.doublePoints = PointerTo<double, vtkDoubleArray>(arrays.Points);
  if (arrays.Normals)
  {
    room.normals = PointerTo<float, vtkFloatArray>(arrays.Normals);
    room.shortNormals = PointerTo<std::int16_t, vtkShortArray>(arrays.Normals);
    room.byteNormals = PointerTo<std::int8_t, vtkSignedCharArray>(arrays.Normals);
  }
  if (arrays.Cells)
  {
    room.cells = static_cast<ink::ActiveCellId*>(arrays.Cells->GetVoidPointer(0));
  }
  return room;
}

void InkKeptSamples::Release()
{
  this->Points = nullptr;
  this->Normals = this->Radii = this->SurfaceIndex = this->CellIds = this->Vertices = nullptr;
}

void InkKeptSamples::Fill(const Contents& contents, vtkPolyData* output)
{
  const auto count =
    static_cast<vtkIdType>(std::accumulate(this->Counts.begin(), this->Counts.end(), std::size_t(0)));
  const auto finish = [count](vtkDataArray* array, const char* name)
  {
    InkSetNumberOfTuples(array, count);
    InkTrimArray(array);
    array->SetName(name);
    array->Modified();
  };

  finish(this->Points->GetData(), nullptr);
  this->Points->Modified();
  output->SetPoints(this->Points);
  if (contents.Normals)
  {
    finish(this->Normals, "Normals");
    output->GetPointData()->SetNormals(this->Normals);
  }
  if (contents.Radius)
  {
    // The precision of the points: where float is too coarse for the points, it may be for the radius, too.
    finish(RenewArray(this->Radii, this->Points->GetDataType(), 1), "Radius");
    this->Radii->Fill(*contents.Radius);
    if (contents.Rims)
    {
      InkNarrowRims(this->Points, this->Radii);
    }
    output->GetPointData()->AddArray(this->Radii);
  }
  if (contents.SurfaceIndex && this->Counts.size() > 1)
  {
    finish(RenewArray(this->SurfaceIndex, VTK_INT, 1), "SurfaceIndex");
    int* index = PointerTo<int, vtkIntArray>(this->SurfaceIndex);
    for (std::size_t n = 0; n < this->Counts.size(); ++n)
    {
      index = std::fill_n(index, this->Counts[n], static_cast<int>(n));
    }
    output->GetPointData()->AddArray(this->SurfaceIndex);
  }
  if (contents.CellIds)
  {
    finish(this->CellIds, "CellId");
    output->GetPointData()->AddArray(this->CellIds);
  }
  if (contents.Vertices && count > 0)
  {
    output->SetVerts(InkMakePolyVertex(count, RenewArray(this->Vertices, InkFindIdType(count), 1)));
  }
}
