// SPDX-License-Identifier: BSD-3-Clause
#include "InkSurfaceOf.h"

#include "vtkCellData.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

vtkSmartPointer<vtkPolyData> InkSurfaceOf(vtkPointSet* input)
{
  if (auto* mesh = vtkPolyData::SafeDownCast(input))
  {
    return mesh;
  }
  if (input->GetNumberOfCells() == 0)
  {
    auto cloud = vtkSmartPointer<vtkPolyData>::New();
    cloud->SetPoints(input->GetPoints());
    cloud->GetPointData()->ShallowCopy(input->GetPointData());
    return cloud;
  }
  vtkNew<vtkDataSetSurfaceFilter> filter;
  // What it delegates to has an order of faces that depends on the number of threads.
  filter->DelegationOff();
  filter->SetInputData(input);
  filter->Update();
  vtkSmartPointer<vtkPolyData> surface = filter->GetOutput();
  surface->GetCellData()->SetGlobalIds(nullptr);
  return surface;
}
