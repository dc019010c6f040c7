// SPDX-License-Identifier: BSD-3-Clause
#include "InkLeaves.h"

#include "InkActiveScalars.h"
#include "InkCellCenters.h"
#include "InkHasSurface.h"
#include "InkProbeColors.h"
#include "InkStippleFields.h"

#include "Core/DidYouMean.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkGeometryFilter.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace
{

bool AreStipples(vtkPolyData* data)
{
  return data->GetFieldData()->GetArray(InkStipplesPerElementName) && data->GetNumberOfCells() > 0 &&
    data->GetNumberOfVerts() == data->GetNumberOfCells();
}

/// "'density', 'pressure'", or "none".
std::string Listed(const std::vector<std::string>& names)
{
  std::string list;
  for (const std::string& name : names)
  {
    list += (list.empty() ? "'" : ", '") + name + "'";
  }
  return list.empty() ? "none" : list;
}

/// "with 'density', 'pressure'", or "with none".
std::string NameArrays(vtkImageData* image)
{
  std::vector<std::string> names = InkNamesOfValues(image->GetPointData());
  const std::vector<std::string> ofCells = InkNamesOfValues(image->GetCellData());
  names.insert(names.end(), ofCells.begin(), ofCells.end());
  return "with " + Listed(names);
}

/// See InkLeaves::FindMissingColors. @param points, cells whether those of points, or of cells, do
std::string MissingIn(vtkDataSet* data, const std::string& array, bool points, bool cells)
{
  if (InkFindColors(data) || (points && data->GetPointData()->GetArray(array.c_str())) ||
    (cells && data->GetCellData()->GetArray(array.c_str())))
  {
    return {};
  }
  std::vector<std::string> known;
  std::string lists;
  const auto list = [&](const char* what, vtkDataSetAttributes* values)
  {
    const std::vector<std::string> names = InkNamesOfValues(values);
    known.insert(known.end(), names.begin(), names.end());
    lists += (lists.empty() ? "" : ", ") + (what + Listed(names));
  };
  if (points)
  {
    list("point arrays: ", data->GetPointData());
  }
  if (cells)
  {
    list("cell arrays: ", data->GetCellData());
  }
  return "no numeric array '" + array + "' to color by (" + lists + ")" + ink::didYouMean(array, known);
}

} // namespace

InkLeaves::InkLeaves(vtkDataObject* input, const std::string& array)
{
  if (auto composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    this->Composite = true;
    auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      this->Add(leaves->GetCurrentDataObject(), array);
    }
  }
  else if (input)
  {
    this->Add(input, array);
  }
}

void InkLeaves::Add(vtkDataObject* leaf, const std::string& array)
{
  auto data = vtkDataSet::SafeDownCast(leaf);
  if (!data)
  {
    this->Problem = std::string("a ") + leaf->GetClassName();
    return;
  }
  if (data->GetNumberOfPoints() == 0)
  {
    return;
  }
  auto polyData = vtkPolyData::SafeDownCast(data);
  if (auto image = vtkImageData::SafeDownCast(data))
  {
    const auto values = InkWithActiveScalars(InkWithPointValues(image, array), array);
    if (!array.empty() && !values->GetPointData()->GetScalars())
    {
      this->Problem = "an image without the array '" + array + "', " + NameArrays(image);
      return;
    }
    this->KeptImages.push_back(InkWithFirstComponent(values));
    this->Images.push_back(this->KeptImages.back());
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

std::vector<vtkSmartPointer<vtkPolyData>> InkLeaves::MakeMeshes() const
{
  std::vector<vtkSmartPointer<vtkPolyData>> meshes;
  for (vtkDataSet* data : this->Others)
  {
    vtkSmartPointer<vtkPolyData> mesh = vtkPolyData::SafeDownCast(data);
    if (!mesh)
    {
      vtkNew<vtkGeometryFilter> outside;
      outside->SetInputData(data);
      outside->Update();
      mesh = outside->GetOutput();
    }
    meshes.push_back(mesh);
  }
  meshes.insert(meshes.end(), this->Stipples.begin(), this->Stipples.end());
  return meshes;
}

std::string InkLeaves::FindBesideImages() const
{
  const std::size_t left = this->Stipples.size() + this->Others.size();
  return this->Images.empty() || left == 0
    ? std::string()
    : "nothing is drawn of " + std::to_string(left) + " datasets beside images; expected images alone";
}

std::string InkLeaves::FindMissingColors(const std::string& array) const
{
  const auto find = [&](const auto& leaves, bool points, bool cells)
  {
    std::string problem;
    for (vtkDataSet* leaf : leaves)
    {
      problem = problem.empty() ? MissingIn(leaf, array, points, cells) : problem;
    }
    return problem;
  };
  return !this->Images.empty() ? find(this->Images, true, false)
    : !this->Stipples.empty()  ? find(this->Stipples, false, true)
                               : find(this->Others, true, true);
}

std::string InkLeaves::FindImageProblem() const
{
  for (vtkImageData* image : this->Images)
  {
    if (!image->GetPointData()->GetScalars())
    {
      return "an image without point scalars";
    }
  }
  return {};
}

std::string InkLeaves::DescribeGrids() const
{
  const auto grid = std::find_if(this->Others.begin(), this->Others.end(),
    [](vtkDataSet* data) { return !vtkPolyData::SafeDownCast(data) && data->GetNumberOfCells() > 0; });
  return grid == this->Others.end() ? std::string()
                                    : "the outer surface of a " + std::string((*grid)->GetClassName()) +
      " is drawn; vtkResampleToImage makes an image of it, whose iso-surfaces can be drawn";
}
