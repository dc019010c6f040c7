// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkAddNormals.h"

#include "InkFeatureNormals.h"
#include "InkHasPolygons.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkPolyData.h"

namespace
{

vtkSmartPointer<vtkPolyData> WithNormals(vtkPolyData* mesh)
{
  return InkHasPolygons(mesh) ? InkWithFeatureNormals(mesh) : vtkSmartPointer<vtkPolyData>(mesh);
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
