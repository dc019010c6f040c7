// SPDX-License-Identifier: BSD-3-Clause
#include "InkPointOutput.h"

#include "InkAllocate.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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
  auto priority = vtkSmartPointer<vtkFloatArray>::New();
  priority->SetName("Priority");
  InkSetNumberOfTuples(priority, count);
  const float most = std::nextafter(1.0f, 0.0f);
  for (vtkIdType i = 0; i < count; ++i)
  {
    priority->SetValue(
      i, std::min(static_cast<float>(static_cast<double>(i) / static_cast<double>(count)), most));
  }
  return priority;
}

vtkSmartPointer<vtkDataArray> InkMakeConstant(const char* name, int type, vtkIdType count, double value)
{
  vtkSmartPointer<vtkDataArray> array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
  array->SetName(name);
  InkSetNumberOfTuples(array, count);
  array->Fill(value);
  return array;
}

void InkReorderPoints(vtkPointSet* input, std::span<const std::uint32_t> order, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(order.size());
  vtkNew<vtkIdList> from;
  vtkNew<vtkIdList> to;
  from->SetNumberOfIds(count);
  to->SetNumberOfIds(count);
  std::copy(order.begin(), order.end(), from->GetPointer(0));
  std::iota(to->GetPointer(0), to->GetPointer(0) + count, vtkIdType(0));
  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  InkSetNumberOfPoints(points, count);
  input->GetPoints()->GetData()->GetTuples(from, points->GetData());
  output->SetPoints(points);
  output->GetPointData()->CopyAllOn();
  output->GetPointData()->CopyAllocate(input->GetPointData(), count);
  output->GetPointData()->CopyData(input->GetPointData(), from, to);
  output->GetFieldData()->PassData(input->GetFieldData());
}
