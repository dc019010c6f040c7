// SPDX-License-Identifier: BSD-3-Clause
#include "InkStippleFields.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

void InkAddField(vtkPolyData* output, const char* name, std::span<const double> values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(values.size()));
  array->InsertNextTuple(values.data());
  output->GetFieldData()->AddArray(array);
}

void InkAddStippleFields(vtkPolyData* output, InkElementKind kind, double size, double perElement)
{
  const auto number = static_cast<double>(kind);
  InkAddField(output, InkElementKindName, { &number, 1 });
  InkAddField(output, InkElementSizeName, { &size, 1 });
  InkAddField(output, InkStipplesPerElementName, { &perElement, 1 });
}
