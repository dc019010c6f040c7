// SPDX-License-Identifier: BSD-3-Clause
#include "WritablePoints.h"

#include "PointNames.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace ink::cli
{
namespace
{

vtkSmartPointer<vtkDataArray> converted(vtkDataArray* array, int type)
{
  vtkSmartPointer<vtkDataArray> other = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
  other->DeepCopy(array);
  other->SetName(array->GetName());
  return other;
}

} // namespace

vtkSmartPointer<vtkPolyData> writablePoints(
  vtkPolyData* points, PointFormat format, std::vector<std::string>& notes)
{
  auto writable = vtkSmartPointer<vtkPolyData>::New();
  writable->ShallowCopy(points);
  vtkPointData* kept = writable->GetPointData();
  kept->Initialize();
  for (int i = 0; i < points->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = points->GetPointData()->GetAbstractArray(i);
    // Files give names, and no file can have values without one.
    if (!array->GetName())
    {
      notes.emplace_back("a point array without a name is left out");
      continue;
    }
    const std::string name = std::string("the point array '") + array->GetName() + "' ";
    vtkSmartPointer<vtkDataArray> numbers = vtkDataArray::SafeDownCast(array);
    if (numbers && numbers->GetDataType() == VTK_BIT)
    {
      numbers = converted(numbers, VTK_UNSIGNED_CHAR);
    }
    const TypeNames* type = numbers ? findTypeNames(numbers->GetDataType()) : nullptr;
    if (!type)
    {
      notes.push_back(
        name + "is left out: its values are of type " + array->GetDataTypeAsString() + ", expected numbers");
      continue;
    }
    if (format == PointFormat::Ply && !type->ply)
    {
      notes.push_back(name + "is written in double precision: PLY has no whole numbers of 64 bits");
      numbers = converted(numbers, VTK_DOUBLE);
    }
    kept->AddArray(numbers);
  }
  return writable;
}

} // namespace ink::cli
