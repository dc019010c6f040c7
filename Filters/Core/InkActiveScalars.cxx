// SPDX-License-Identifier: BSD-3-Clause
#include "InkActiveScalars.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <cstring>

bool InkIsGhostArray(const char* name)
{
  return name && std::strcmp(name, vtkDataSetAttributes::GhostArrayName()) == 0;
}

std::pair<bool, std::string> InkRankOfArray(int components, const char* name)
{
  return { components != 1, name ? name : "" };
}

std::vector<std::string> InkNamesOfValues(vtkDataSetAttributes* attributes)
{
  std::vector<std::string> names;
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = attributes->GetArray(i);
    if (array && array->GetName() && !InkIsGhostArray(array->GetName()))
    {
      names.emplace_back(array->GetName());
    }
  }
  return names;
}

vtkDataArray* InkFirstValues(vtkDataSetAttributes* attributes)
{
  const auto rankOf = [](vtkDataArray* array)
  { return InkRankOfArray(array->GetNumberOfComponents(), array->GetName()); };
  vtkDataArray* first = nullptr;
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = attributes->GetArray(i);
    if (array && !InkIsGhostArray(array->GetName()) && (!first || rankOf(array) < rankOf(first)))
    {
      first = array;
    }
  }
  return first;
}

bool InkLacksActiveScalars(vtkImageData* image)
{
  return !image->GetPointData()->GetScalars() && InkFirstValues(image->GetPointData());
}

vtkSmartPointer<vtkImageData> InkWithActiveScalars(vtkImageData* image, const std::string& array)
{
  vtkPointData* values = image->GetPointData();
  vtkDataArray* wanted = !array.empty() ? values->GetArray(array.c_str())
    : InkLacksActiveScalars(image)      ? InkFirstValues(values)
                                        : values->GetScalars();
  if (wanted == values->GetScalars())
  {
    return image;
  }
  auto active = vtkSmartPointer<vtkImageData>::New();
  active->ShallowCopy(image);
  active->GetPointData()->SetActiveScalars(nullptr);
  if (wanted)
  {
    active->GetPointData()->SetScalars(wanted);
  }
  return active;
}

void InkSelectScalars(vtkAlgorithm* filter, const std::string& array)
{
  if (array.empty())
  {
    filter->SetInputArrayToProcess(
      0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  }
  else
  {
    filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array.c_str());
  }
}

vtkSmartPointer<vtkImageData> InkWithFirstComponent(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfComponents() < 2)
  {
    return image;
  }
  const auto first = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(scalars->GetDataType()));
  first->SetName(scalars->GetName());
  first->SetNumberOfTuples(scalars->GetNumberOfTuples());
  first->CopyComponent(0, scalars, 0);
  auto single = vtkSmartPointer<vtkImageData>::New();
  single->ShallowCopy(image);
  single->GetPointData()->SetScalars(first);
  return single;
}
