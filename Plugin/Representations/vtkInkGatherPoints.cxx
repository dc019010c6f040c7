// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkGatherPoints.h"

#include "vtkAppendPolyData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <sstream>

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
  message << (arrays ? "." : "no point array.");
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
  constexpr unsigned char notOwned = vtkDataSetAttributes::DUPLICATEPOINT | vtkDataSetAttributes::HIDDENPOINT;
  auto owned = vtkSmartPointer<vtkIdList>::New();
  for (vtkIdType i = 0; i < ghosts->GetNumberOfTuples(); ++i)
  {
    if (!(ghosts->GetValue(i) & notOwned))
    {
      owned->InsertNextId(i);
    }
  }
  return owned->GetNumberOfIds() < ghosts->GetNumberOfTuples() ? owned : nullptr;
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

vtkSmartPointer<vtkPolyData> TakeLeaf(vtkPointSet* leaf, vtkDataArray* normals, vtkIdList* ids)
{
  auto taken = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetData(Take(leaf->GetPoints()->GetData(), ids, "Points"));
  taken->SetPoints(points);
  taken->GetPointData()->SetNormals(Take(normals, ids, "Normals"));
  if (vtkDataArray* radius = FindArray(leaf->GetPointData(), "Radius", 1))
  {
    taken->GetPointData()->AddArray(Take(radius, ids, "Radius"));
  }
  return taken;
}

class Gatherer
{
public:
  void Add(vtkDataObject* leaf)
  {
    auto points = vtkPointSet::SafeDownCast(leaf);
    if (!points)
    {
      this->Report(std::string("a ") + leaf->GetClassName() + ". It needs points, in any vtkPointSet.");
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
    this->Last = TakeLeaf(points, normals, owned);
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

  vtkNew<vtkAppendPolyData> Append;
  vtkSmartPointer<vtkPolyData> Last = vtkSmartPointer<vtkPolyData>::New();
  int Leaves = 0;
};

} // namespace

vtkInkGatheredPoints vtkInkGatherPoints(vtkDataObject* input)
{
  Gatherer gatherer;
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
