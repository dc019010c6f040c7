// SPDX-License-Identifier: BSD-3-Clause
#include "InkStippleOutput.h"

#include "InkAllocate.h"
#include "InkMemoryBudget.h"
#include "InkVTKCompat.h"

#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <limits>
#include <string>

ink::Progress InkPartOfProgress(const ink::Progress& progress, double begin, double end)
{
  if (!progress)
  {
    return {};
  }
  return [progress, begin, end](double share) { return progress(begin + share * (end - begin)); };
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
  InkCheckMemory(count, bytes, "stipples", std::numeric_limits<double>::infinity(),
    ": raise the threshold or lower MaximumStipples");
}
