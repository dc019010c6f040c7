// SPDX-License-Identifier: BSD-3-Clause
#include "InkStippleNumbers.h"

#include "InkStippleFields.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace
{

constexpr const char* FieldNames[] = { InkElementKindName, InkElementSizeName, InkStipplesPerElementName };

vtkSmartPointer<vtkDoubleArray> MakeNumber(const char* name, double value)
{
  auto number = vtkSmartPointer<vtkDoubleArray>::New();
  number->SetName(name);
  number->InsertNextValue(value);
  return number;
}

} // namespace

void InkWriteNumbers(vtkPolyData* stipples, vtkPolyData* numbers)
{
  numbers->Initialize();
  if (stipples->GetNumberOfPoints() == 0)
  {
    return;
  }
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(stipples->GetPoint(0));
  numbers->SetPoints(points);
  for (const char* name : FieldNames)
  {
    vtkDataArray* known = stipples->GetFieldData()->GetArray(name);
    const bool has = known && known->GetNumberOfTuples() > 0;
    numbers->GetPointData()->AddArray(MakeNumber(name, has ? known->GetComponent(0, 0) : 1.0));
  }
}

void InkReadNumbers(vtkPolyData* numbers, vtkPolyData* stipples)
{
  vtkPointData* values = numbers->GetPointData();
  vtkNew<vtkFieldData> field;
  for (const char* name : FieldNames)
  {
    field->AddArray(MakeNumber(name, values->GetArray(name)->GetComponent(0, 0)));
  }
  stipples->SetFieldData(field);
}
