// SPDX-License-Identifier: BSD-3-Clause
#include "InkScalarColors.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"

#include <limits>
#include <sstream>

InkScalarColors::InkScalarColors(vtkMapper* mapper, vtkDataSet* input, Of of)
  : Mapper(mapper)
  , Input(input)
{
  if (!mapper->GetScalarVisibility())
  {
    return;
  }
  int found = 0; // 0: of points, 1: of cells, 2: of the data
  this->Scalars = vtkAbstractMapper::GetAbstractScalars(input, mapper->GetScalarMode(),
    mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), found);
  const bool ofPoints = of == Of::Points;
  const vtkIdType expected = ofPoints ? input->GetNumberOfPoints() : input->GetNumberOfCells();
  if (this->Scalars && (found != (ofPoints ? 0 : 1) || this->Scalars->GetNumberOfTuples() != expected))
  {
    const char* const owners[3] = { "points", "cells", "the data" };
    std::ostringstream message;
    message << "Expected scalars of " << owners[ofPoints ? 0 : 1] << ", of which there are " << expected
            << ", to color by; found " << this->Scalars->GetNumberOfTuples() << " of " << owners[found]
            << ". The drawing has the ink's colors.";
    this->Problem = message.str();
    this->Scalars = nullptr;
  }
}

std::string InkScalarColors::Describe() const
{
  if (!this->Scalars)
  {
    return "";
  }
  // As MapScalars chooses it.
  auto* array = vtkDataArray::SafeDownCast(this->Scalars);
  vtkScalarsToColors* table =
    array && array->GetLookupTable() ? array->GetLookupTable() : this->Mapper->GetLookupTable();
  const double* range = this->Mapper->GetScalarRange();
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  // Modification times are unique, so no pointers are needed.
  text << this->Scalars->GetMTime() << ' ' << table->GetMTime() << ' ' << this->Mapper->GetColorMode() << ' '
       << this->Mapper->GetUseLookupTableScalarRange() << ' ' << range[0] << ' ' << range[1] << ' '
       << this->Mapper->GetFieldDataTupleId() << ' ' << this->Mapper->GetArrayComponent();
  return text.str();
}

vtkUnsignedCharArray* InkScalarColors::Map() const
{
  if (!this->Scalars)
  {
    return nullptr;
  }
  // Marks have no texture coordinates.
  const auto interpolate = this->Mapper->GetInterpolateScalarsBeforeMapping();
  this->Mapper->SetInterpolateScalarsBeforeMapping(0);
  int ofCells = 0;
  vtkUnsignedCharArray* colors = this->Mapper->MapScalars(this->Input, 1.0, ofCells);
  this->Mapper->SetInterpolateScalarsBeforeMapping(interpolate);
  return colors;
}
