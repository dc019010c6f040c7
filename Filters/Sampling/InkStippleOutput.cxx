// SPDX-License-Identifier: BSD-3-Clause
#include "InkStippleOutput.h"

#include "InkAllocate.h"
#include "InkVTKCompat.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <vtksys/SystemInformation.hxx>

#include <algorithm>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>

namespace
{

template <class IdArray>
vtkSmartPointer<vtkCellArray> MakePolyVertices(std::span<const vtkIdType> begins)
{
  using Id = typename IdArray::ValueType;
  vtkNew<IdArray> offsets;
  InkSetNumberOfTuples(offsets, static_cast<vtkIdType>(begins.size()));
  std::transform(
    begins.begin(), begins.end(), offsets->GetPointer(0), [](vtkIdType id) { return static_cast<Id>(id); });
  vtkNew<IdArray> points;
  InkSetNumberOfTuples(points, begins.back());
  std::iota(points->GetPointer(0), points->GetPointer(0) + begins.back(), Id(0));
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, points);
  return cells;
}

} // namespace

ink::Progress InkPartOfProgress(const ink::Progress& progress, double begin, double end)
{
  if (!progress)
  {
    return {};
  }
  return [progress, begin, end](double share) { return progress(begin + share * (end - begin)); };
}

vtkSmartPointer<vtkCellArray> InkMakePolyVertices(std::span<const vtkIdType> begins)
{
  return begins.back() <= std::numeric_limits<vtkTypeInt32>::max()
    ? MakePolyVertices<vtkTypeInt32Array>(begins)
    : MakePolyVertices<vtkTypeInt64Array>(begins);
}

vtkSmartPointer<vtkDataArray> InkPickTuples(vtkDataArray* array, const std::vector<vtkIdType>& ids)
{
  vtkNew<vtkIdList> list;
  list->SetNumberOfIds(static_cast<vtkIdType>(ids.size()));
  std::copy(ids.begin(), ids.end(), list->GetPointer(0));
  vtkSmartPointer<vtkDataArray> result =
    vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(array->GetDataType()));
  result->SetName(array->GetName());
  result->SetNumberOfComponents(array->GetNumberOfComponents());
  InkSetNumberOfTuples(result, list->GetNumberOfIds());
  array->GetTuples(list, result);
  return result;
}

void InkAddField(vtkPolyData* output, const char* name, std::span<const double> values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(values.size()));
  array->InsertNextTuple(values.data());
  output->GetFieldData()->AddArray(array);
}

void InkAddColors(vtkPolyData* output, vtkDataArray* colors)
{
  const char* name = colors->GetName();
  if (name && output->GetCellData()->HasArray(name))
  {
    colors->SetName((std::string("Input") + name).c_str());
  }
  output->GetCellData()->SetScalars(colors);
}

void InkCheckStippleMemory(double count, double bytes)
{
  vtksys::SystemInformation system;
  const double available = 1024.0 * static_cast<double>(system.GetHostMemoryTotal());
  if (count * bytes > available)
  {
    std::ostringstream text;
    text << count << " stipples would take " << count * bytes / 0x1p30
         << " GiB of memory; expected no more than " << available / bytes
         << " stipples on this machine: raise the threshold or lower MaximumStipples";
    throw std::invalid_argument(text.str());
  }
}
