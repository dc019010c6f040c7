// SPDX-License-Identifier: BSD-3-Clause
#include "InkStippleInput.h"

#include "InkArrayList.h"
#include "InkStippleFields.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

namespace
{

double FindNumber(vtkPolyData* data, const char* name, double missing)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : missing;
}

bool IsCellArray(vtkDataArray* array, int components, vtkIdType cells)
{
  return array && array->GetNumberOfComponents() == components && array->GetNumberOfTuples() == cells;
}

/// By the field data; where they are neither kind's, volumes have gradients.
bool IsSurface(vtkPolyData* data, bool hasGradients)
{
  const double kind = FindNumber(data, InkElementKindName, -1.0);
  const auto is = [kind](InkElementKind one) { return kind == static_cast<double>(one); };
  return is(InkElementKind::Surface) || (!is(InkElementKind::Volume) && !hasGradients);
}

/// Whether cell e holds the points offset[e], offset[e] + 1 ... and all cells together all points.
bool HoldsPointsInOrder(vtkCellArray* cells, vtkIdType points)
{
  vtkDataArray* connectivity = cells->GetConnectivityArray();
  if (connectivity->GetNumberOfTuples() != points)
  {
    return false;
  }
  vtkIdType expected = 0;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    cells->GetCellAtId(cell, size, ids);
    for (vtkIdType i = 0; i < size; ++i, ++expected)
    {
      if (ids[i] != expected)
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace

InkStippleInput::InkStippleInput(vtkPolyData* data)
  : Data(data)
  , Normals(data->GetCellData()->GetArray("Normals"))
  , GradientMagnitudes(data->GetCellData()->GetArray("GradientMagnitude"))
  , Values(data->GetCellData()->GetArray("Value"))
  , GlobalIds(data->GetCellData()->GetGlobalIds())
  , Surface(IsSurface(data, this->GradientMagnitudes != nullptr))
  , ElementSize(FindNumber(data, InkElementSizeName, 0.0))
  , StipplesPerElement(FindNumber(data, InkStipplesPerElementName, 0.0))
{
  if (!IsCellArray(this->GlobalIds, 1, data->GetNumberOfCells()))
  {
    this->GlobalIds = nullptr;
  }
  if (!(this->StipplesPerElement > 0.0 && std::isfinite(this->StipplesPerElement)))
  {
    this->StipplesPerElement = 0.0;
  }
}

std::string InkStippleInput::FindProblem() const
{
  vtkCellArray* cells = this->Data->GetVerts();
  const vtkIdType elements = cells->GetNumberOfCells();
  const vtkIdType points = this->Data->GetNumberOfPoints();
  std::ostringstream problem;
  if (this->Data->GetNumberOfCells() != elements || !HoldsPointsInOrder(cells, points))
  {
    problem << "Expected stipples as vtkInkStippleGenerator makes them: one poly-vertex for each element, "
               "together all points in their order. Found "
            << points << " points, " << elements << " vertex cells and "
            << this->Data->GetNumberOfCells() - elements << " other cells.";
    return problem.str();
  }
  const auto require = [&](vtkDataArray* array, const char* name, int components)
  {
    if (problem.str().empty() && !IsCellArray(array, components, elements))
    {
      problem << "No cell array \"" << name << "\" with " << components
              << (components == 1 ? " component" : " components") << " for " << elements
              << " elements. Cell arrays (components) in the input: "
              << InkListArrays(this->Data->GetCellData()) << '.';
    }
  };
  require(this->Normals, "Normals", 3);
  if (!this->Surface)
  {
    require(this->GradientMagnitudes, "GradientMagnitude", 1);
    require(this->Values, "Value", 1);
  }
  if (problem.str().empty() && !(this->ElementSize > 0.0 && std::isfinite(this->ElementSize)))
  {
    problem << "The field array \"" << InkElementSizeName
            << "\" should hold the elements' size in world units, found " << this->ElementSize
            << ". Field arrays (components) in the input: " << InkListArrays(this->Data->GetFieldData())
            << '.';
  }
  return problem.str();
}

InkStippleInput::Key InkStippleInput::GetKey() const
{
  vtkCellArray* cells = this->Data->GetVerts();
  vtkObject* const arrays[] = { this->Data->GetPoints()->GetData(), cells, cells->GetConnectivityArray(),
    cells->GetOffsetsArray(), this->Normals, this->GradientMagnitudes, this->Values, this->GlobalIds };
  Key key{ {}, this->Surface, this->ElementSize, this->StipplesPerElement };
  static_assert(std::size(arrays) == std::tuple_size_v<decltype(key.Arrays)>);
  std::transform(std::begin(arrays), std::end(arrays), key.Arrays.begin(),
    [](vtkObject* array) { return array ? array->GetMTime() : 0; });
  return key;
}
