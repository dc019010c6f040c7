// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkAddNormals.h"

#include "InkHasPolygons.h"
#include "InkPointNormals.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"

namespace
{

bool LacksNormals(vtkPolyData* mesh)
{
  return InkHasPolygons(mesh) && !InkPointNormals(mesh);
}

vtkSmartPointer<vtkPolyData> WithNormals(vtkPolyData* mesh)
{
  if (!LacksNormals(mesh))
  {
    return mesh;
  }
  vtkNew<vtkPolyData> polygons;
  polygons->SetPoints(mesh->GetPoints());
  polygons->SetPolys(mesh->GetPolys());
  polygons->SetStrips(mesh->GetStrips());
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(polygons);
  normals->SplittingOff();
  normals->ComputeCellNormalsOff();
  normals->Update();
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(mesh);
  result->GetPointData()->SetNormals(normals->GetOutput()->GetPointData()->GetNormals());
  return result;
}

} // namespace

vtkSmartPointer<vtkDataObject> vtkInkAddNormals(vtkDataObject* data)
{
  if (auto mesh = vtkPolyData::SafeDownCast(data))
  {
    return WithNormals(mesh);
  }
  auto composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    return data;
  }
  auto result = vtk::TakeSmartPointer(composite->NewInstance());
  result->CopyStructure(composite);
  auto leaves = vtk::TakeSmartPointer(composite->NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    vtkSmartPointer<vtkDataObject> leaf = leaves->GetCurrentDataObject();
    if (auto mesh = vtkPolyData::SafeDownCast(leaf))
    {
      leaf = WithNormals(mesh);
    }
    result->SetDataSet(leaves, leaf);
  }
  return result;
}
