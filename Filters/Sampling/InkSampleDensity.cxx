// SPDX-License-Identifier: BSD-3-Clause
#include "InkSampleDensity.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <stdexcept>

vtkDataArray* InkGetDensity(vtkPolyData* mesh, const char* name, int association)
{
  const bool ofCells = association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  vtkDataSetAttributes* data = ofCells ? static_cast<vtkDataSetAttributes*>(mesh->GetCellData())
                                       : static_cast<vtkDataSetAttributes*>(mesh->GetPointData());
  const vtkIdType expected = ofCells ? mesh->GetNumberOfCells() : mesh->GetNumberOfPoints();
  const std::string kind = ofCells ? "cell" : "point";
  vtkDataArray* density = data->GetArray(name);
  if (!density)
  {
    std::string found;
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      const char* other = data->GetArrayName(i);
      found += (i ? ", \"" : "\"") + std::string(other ? other : "") + "\"";
    }
    throw std::invalid_argument("there is no numeric " + kind + " array \"" + name +
      "\" for the density; found " + (found.empty() ? "none" : found));
  }
  if (density->GetNumberOfComponents() != 1 || density->GetNumberOfTuples() != expected)
  {
    throw std::invalid_argument("the density array " + std::string(name) + " has " +
      std::to_string(density->GetNumberOfTuples()) + " values of " +
      std::to_string(density->GetNumberOfComponents()) + " components; expected " + std::to_string(expected) +
      " of 1");
  }
  return density;
}

std::string InkDescribeUnusableDensity(vtkDataArray* density)
{
  vtkIdType negative = 0;
  vtkIdType notNumbers = 0;
  for (vtkIdType i = 0; i < density->GetNumberOfTuples(); ++i)
  {
    const double value = density->GetComponent(i, 0);
    negative += value < 0.0 ? 1 : 0;
    notNumbers += std::isnan(value) ? 1 : 0;
  }
  std::string text = negative > 0 ? std::to_string(negative) + " negative values" : "";
  if (notNumbers > 0)
  {
    text += (text.empty() ? "" : " and ") + std::to_string(notNumbers) + " that are NaN";
  }
  return text;
}
