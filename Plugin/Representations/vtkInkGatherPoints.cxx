// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkGatherPoints.h"

#include "InkGhostPoint.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <sstream>
#include <utility>

namespace
{

vtkDataArray* FindArray(vtkPointData* pointData, const char* name, int components)
{
  vtkDataArray* array = pointData->GetArray(name);
  return array && array->GetNumberOfComponents() == components ? array : nullptr;
}

vtkDataArray* FindNormals(vtkPointData* pointData)
{
  vtkDataArray* normals = FindArray(pointData, "Normals", 3);
  return normals ? normals : pointData->GetNormals();
}

std::string NoNormals(vtkPointSet* leaf)
{
  std::ostringstream message;
  message << "a " << leaf->GetClassName() << " of " << leaf->GetNumberOfPoints()
          << " points without normals. It needs the point array \"Normals\" of 3 components; found ";
  vtkPointData* pointData = leaf->GetPointData();
  const int arrays = pointData->GetNumberOfArrays();
  for (int i = 0; i < arrays; ++i)
  {
    const char* name = pointData->GetArrayName(i);
    message << (i ? ", " : "") << '"' << (name ? name : "") << "\" of "
            << pointData->GetAbstractArray(i)->GetNumberOfComponents();
  }
  message << (arrays ? "" : "no point array");
  return message.str();
}

// Null if all points are owned.
vtkSmartPointer<vtkIdList> OwnedPoints(vtkPointSet* leaf)
{
  vtkUnsignedCharArray* ghosts = leaf->GetPointGhostArray();
  if (!ghosts)
  {
    return nullptr;
  }
  auto owned = vtkSmartPointer<vtkIdList>::New();
  for (vtkIdType i = 0; i < leaf->GetNumberOfPoints(); ++i)
  {
    if (!InkIsGhostPoint(ghosts, i))
    {
      owned->InsertNextId(i);
    }
  }
  return owned->GetNumberOfIds() < leaf->GetNumberOfPoints() ? owned : nullptr;
}

// The array under the given name, of the listed points only unless the list is null.
vtkSmartPointer<vtkDataArray> Take(vtkDataArray* array, vtkIdList* ids, const char* name)
{
  auto taken = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
  if (ids)
  {
    taken->SetNumberOfComponents(array->GetNumberOfComponents());
    taken->SetNumberOfTuples(ids->GetNumberOfIds());
    array->GetTuples(ids, taken);
  }
  else
  {
    taken->ShallowCopy(array);
  }
  taken->SetName(name);
  return taken;
}

// The array to color by, one value a point; null if there is none.
vtkSmartPointer<vtkDataArray> FindColors(vtkPointSet* leaf, const std::string& name, int association)
{
  if (association != vtkDataObject::FIELD_ASSOCIATION_CELLS)
  {
    return leaf->GetPointData()->GetArray(name.c_str());
  }
  vtkDataArray* ofCells = leaf->GetCellData()->GetArray(name.c_str());
  if (!ofCells)
  {
    return nullptr;
  }
  auto cells = vtkSmartPointer<vtkPointSet>::Take(leaf->NewInstance());
  cells->CopyStructure(leaf);
  cells->GetCellData()->AddArray(ofCells);
  vtkNew<vtkCellDataToPointData> toPoints;
  toPoints->SetInputData(cells);
  toPoints->Update();
  return toPoints->GetOutput()->GetPointData()->GetArray(name.c_str());
}

vtkSmartPointer<vtkPolyData> TakeLeaf(
  vtkPointSet* leaf, vtkDataArray* normals, vtkDataArray* colors, vtkIdList* ids)
{
  auto taken = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetData(Take(leaf->GetPoints()->GetData(), ids, "Points"));
  taken->SetPoints(points);
  vtkPointData* pointData = taken->GetPointData();
  pointData->SetNormals(Take(normals, ids, "Normals"));
  for (const char* name : { "Radius", "Priority" })
  {
    if (vtkDataArray* array = FindArray(leaf->GetPointData(), name, 1))
    {
      pointData->AddArray(Take(array, ids, name));
    }
  }
  if (colors)
  {
    // Under a name of its own, as it may be one of the above.
    pointData->SetScalars(Take(colors, ids, "InkColors"));
  }
  return taken;
}

class Gatherer
{
public:
  Gatherer(std::string colorArray, int association)
    : ColorArray(std::move(colorArray))
    , Association(association)
  {
  }

  void Add(vtkDataObject* leaf)
  {
    auto points = vtkPointSet::SafeDownCast(leaf);
    if (!points)
    {
      this->Report(std::string("a ") + leaf->GetClassName() + ". It needs points, in any vtkPointSet");
      return;
    }
    if (points->GetNumberOfPoints() == 0)
    {
      return;
    }
    vtkDataArray* normals = FindNormals(points->GetPointData());
    if (!normals)
    {
      this->Report(NoNormals(points));
      return;
    }
    const auto owned = OwnedPoints(points);
    this->Result.IdsAreInputs &= !owned;
    const auto colors = FindColors(points, this->ColorArray, this->Association);
    this->Last = TakeLeaf(points, normals, colors, owned);
    this->Append->AddInputData(this->Last);
    ++this->Leaves;
  }

  vtkInkGatheredPoints Finish()
  {
    if (this->Leaves > 1)
    {
      this->Append->Update();
      this->Last = this->Append->GetOutput();
    }
    this->Result.Points = this->Last;
    return this->Result;
  }

  vtkInkGatheredPoints Result;

private:
  void Report(const std::string& problem)
  {
    if (this->Result.Problem.empty())
    {
      this->Result.Problem = problem;
    }
  }

  const std::string ColorArray;
  const int Association;
  vtkNew<vtkAppendPolyData> Append;
  vtkSmartPointer<vtkPolyData> Last = vtkSmartPointer<vtkPolyData>::New();
  int Leaves = 0;
};

} // namespace

vtkInkGatheredPoints vtkInkGatherPoints(vtkDataObject* input, const std::string& colorArray, int association)
{
  Gatherer gatherer(colorArray, association);
  if (auto composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    gatherer.Result.IdsAreInputs = false;
    auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      gatherer.Add(leaves->GetCurrentDataObject());
    }
  }
  else if (input)
  {
    gatherer.Add(input);
  }
  return gatherer.Finish();
}
