// SPDX-License-Identifier: BSD-3-Clause
// Colours of points by scalars.
#include "vtkInkSplattingLinesMapper.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkPolyData.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"

#include <sstream>
#include <utility>

vtkAbstractArray* vtkInkSplattingLinesMapper::FindScalars()
{
  if (this->InkColorMode != SCALARS || !this->ScalarVisibility)
  {
    return nullptr;
  }
  vtkPolyData* input = this->GetInput();
  int ofCells = 0;
  vtkAbstractArray* scalars = GetAbstractScalars(
    input, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, ofCells);
  if (scalars && (ofCells || scalars->GetNumberOfTuples() != input->GetNumberOfPoints()))
  {
    std::ostringstream message;
    message << "Colours come from scalars of points, of which there are " << input->GetNumberOfPoints()
            << "; found " << scalars->GetNumberOfTuples() << " of " << (ofCells ? "cells" : "the data")
            << ". The lines have the ink's colours.";
    this->ReportOnce(message.str());
    return nullptr;
  }
  return scalars;
}

std::string vtkInkSplattingLinesMapper::DescribeColors()
{
  vtkAbstractArray* scalars = this->FindScalars();
  if (!scalars)
  {
    return "";
  }
  // As MapScalars chooses it.
  auto* array = vtkDataArray::SafeDownCast(scalars);
  vtkScalarsToColors* table =
    array && array->GetLookupTable() ? array->GetLookupTable() : this->GetLookupTable();
  std::ostringstream text;
  text << scalars->GetMTime() << ' ' << table->GetMTime() << ' ' << this->ColorMode << ' '
       << this->UseLookupTableScalarRange << ' ' << this->ScalarRange[0] << ' ' << this->ScalarRange[1] << ' '
       << this->FieldDataTupleId << ' ' << this->ArrayComponent;
  return text.str();
}

vtkUnsignedCharArray* vtkInkSplattingLinesMapper::MapColors()
{
  if (!this->FindScalars())
  {
    return nullptr;
  }
  // Points have no texture coordinates.
  const auto interpolate = std::exchange(this->InterpolateScalarsBeforeMapping, 0);
  int ofCells = 0;
  vtkUnsignedCharArray* colors = this->MapScalars(this->GetInput(), 1.0, ofCells);
  this->InterpolateScalarsBeforeMapping = interpolate;
  return colors;
}
