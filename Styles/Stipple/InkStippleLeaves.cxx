// SPDX-License-Identifier: BSD-3-Clause
#include "InkStippleLeaves.h"

#include "InkSurfaceKind.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace
{

bool AreStipples(vtkPolyData* data)
{
  return data->GetFieldData()->GetArray("StipplesPerElement") && data->GetNumberOfCells() > 0 &&
    data->GetNumberOfVerts() == data->GetNumberOfCells();
}

} // namespace

bool InkHasSurface(vtkPolyData* data)
{
  return InkHasPolygons(data) || InkHasDiscs(data);
}

InkStippleLeaves::InkStippleLeaves(vtkDataObject* input)
{
  if (auto composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    this->Composite = true;
    auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      this->Add(leaves->GetCurrentDataObject());
    }
  }
  else if (input)
  {
    this->Add(input);
  }
}

void InkStippleLeaves::Add(vtkDataObject* leaf)
{
  auto data = vtkDataSet::SafeDownCast(leaf);
  if (!data)
  {
    this->Problem = std::string("a ") + leaf->GetClassName() + ". It needs images, meshes or stipples";
    return;
  }
  if (data->GetNumberOfPoints() == 0)
  {
    return;
  }
  auto polyData = vtkPolyData::SafeDownCast(data);
  if (auto image = vtkImageData::SafeDownCast(data))
  {
    this->Images.push_back(image);
  }
  else if (polyData && AreStipples(polyData))
  {
    this->Stipples.push_back(polyData);
  }
  else
  {
    this->Others.push_back(data);
  }
}

std::string InkReasonAgainstStipples(vtkDataObject* data)
{
  const std::string wanted = "expected an image, a mesh, points with Normals and Radius or stipples, found ";
  const InkStippleLeaves leaves(data);
  if (!leaves.Problem.empty())
  {
    return wanted + leaves.Problem;
  }
  const std::size_t count = leaves.Images.size() + leaves.Stipples.size() + leaves.Others.size();
  auto* only = count == 1 && !leaves.Others.empty() ? vtkPolyData::SafeDownCast(leaves.Others[0]) : nullptr;
  return count == 0                ? wanted + "data without points"
    : only && !InkHasSurface(only) ? wanted + "points without polygons"
                                   : std::string();
}
