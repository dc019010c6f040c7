// SPDX-License-Identifier: BSD-3-Clause
#include "InkCellCenters.h"

#include "InkActiveScalars.h"
#include "InkImageGrid.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>

namespace
{

/// Whether pipeline information tells of an array of that name, or of any that has values.
bool IsAnnounced(vtkInformation* info, int association, const std::string& array)
{
  if (!array.empty())
  {
    return vtkDataObject::GetNamedFieldInformation(info, association, array.c_str()) != nullptr;
  }
  vtkInformationVector* fields =
    info->Get(association == vtkDataObject::FIELD_ASSOCIATION_CELLS ? vtkDataObject::CELL_DATA_VECTOR()
                                                                    : vtkDataObject::POINT_DATA_VECTOR());
  for (int i = 0; fields && i < fields->GetNumberOfInformationObjects(); ++i)
  {
    if (!InkIsGhostArray(fields->GetInformationObject(i)->Get(vtkDataObject::FIELD_NAME())))
    {
      return true;
    }
  }
  return false;
}

/// The name of a filter's array to process 0; empty where it is an attribute, as the active scalars.
std::string NameOfChosen(vtkAlgorithm* filter)
{
  const char* name = filter->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
  return name ? name : "";
}

/// Marks centers whose cells are marked, and the cells between centers.
void TakeMarks(vtkUnsignedCharArray* marks, vtkImageData* centers)
{
  using Marks = vtkDataSetAttributes;
  const auto add = [](vtkDataSetAttributes* to, vtkIdType count)
  {
    vtkNew<vtkUnsignedCharArray> array;
    array->SetName(Marks::GhostArrayName());
    array->SetNumberOfValues(count);
    array->FillValue(0);
    to->AddArray(array);
    return array->GetPointer(0);
  };
  const unsigned char* ofCells = marks->GetPointer(0);
  const vtkIdType points = centers->GetNumberOfPoints();
  unsigned char* ofPoints = add(centers->GetPointData(), points);
  for (vtkIdType i = 0; i < points; ++i)
  {
    ofPoints[i] = static_cast<unsigned char>((ofCells[i] & Marks::DUPLICATECELL ? Marks::DUPLICATEPOINT : 0) |
      (ofCells[i] & Marks::HIDDENCELL ? Marks::HIDDENPOINT : 0));
  }
  const int* d = centers->GetDimensions();
  const std::array<vtkIdType, 3> steps{ 1, d[0], static_cast<vtkIdType>(d[0]) * d[1] };
  std::array<int, 3> cells;
  std::transform(d, d + 3, cells.begin(), [](int along) { return std::max(along - 1, 1); });
  unsigned char* between = add(centers->GetCellData(), centers->GetNumberOfCells());
  for (int z = 0; z < cells[2]; ++z)
  {
    for (int y = 0; y < cells[1]; ++y)
    {
      for (int x = 0; x < cells[0]; ++x)
      {
        const unsigned char* first = ofCells + x + y * steps[1] + z * steps[2];
        unsigned char refined = Marks::REFINEDCELL;
        for (int corner = 0; corner < 8; ++corner)
        {
          vtkIdType step = 0;
          for (int axis = 0; axis < 3; ++axis)
          {
            step += (corner >> axis & 1) && d[axis] > 1 ? steps[static_cast<std::size_t>(axis)] : 0;
          }
          refined &= first[step];
        }
        *between++ = static_cast<unsigned char>((*first & Marks::DUPLICATECELL) | refined);
      }
    }
  }
}

} // namespace

bool InkTakesCells(vtkImageData* image, const std::string& array)
{
  vtkPointData* points = image->GetPointData();
  vtkCellData* cells = image->GetCellData();
  return array.empty() ? !InkFirstValues(points) && InkFirstValues(cells)
                       : !points->HasArray(array.c_str()) && cells->GetArray(array.c_str());
}

bool InkAnnouncesCells(vtkInformation* info, const std::string& array)
{
  return !IsAnnounced(info, vtkDataObject::FIELD_ASSOCIATION_POINTS, array) &&
    IsAnnounced(info, vtkDataObject::FIELD_ASSOCIATION_CELLS, array);
}

void InkToCellExtent(int extent[6])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    extent[2 * axis + 1] -= extent[2 * axis + 1] > extent[2 * axis] ? 1 : 0;
  }
}

void InkToPointExtent(int extent[6], const int whole[6])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool isEmpty = extent[2 * axis] > extent[2 * axis + 1];
    extent[2 * axis + 1] += !isEmpty && whole[2 * axis + 1] > whole[2 * axis] ? 1 : 0;
  }
}

void InkMoveToCellCenters(vtkImageData* frame)
{
  int extent[6];
  double half[3];
  double center[3];
  frame->GetExtent(extent);
  for (int axis = 0; axis < 3; ++axis)
  {
    half[axis] = extent[2 * axis + 1] > extent[2 * axis] ? 0.5 : 0.0;
  }
  frame->TransformContinuousIndexToPhysicalPoint(half, center);
  InkToCellExtent(extent);
  frame->SetExtent(extent);
  frame->SetOrigin(center);
}

vtkSmartPointer<vtkImageData> InkMakePointFrame(vtkInformation* info, const std::string& array)
{
  vtkSmartPointer<vtkImageData> frame = InkMakeFrame(info);
  if (InkAnnouncesCells(info, array))
  {
    InkMoveToCellCenters(frame);
  }
  return frame;
}

vtkSmartPointer<vtkImageData> InkAtCellCenters(vtkImageData* image)
{
  auto centers = vtkSmartPointer<vtkImageData>::New();
  centers->CopyStructure(image);
  // Of a grid with blanked points the structure has their marks.
  centers->GetPointData()->Initialize();
  centers->GetCellData()->Initialize();
  InkMoveToCellCenters(centers);
  vtkCellData* cells = image->GetCellData();
  vtkPointData* values = centers->GetPointData();
  values->ShallowCopy(cells);
  values->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  if (!values->GetScalars())
  {
    values->SetScalars(InkFirstValues(values));
  }
  auto* marks =
    vtkUnsignedCharArray::SafeDownCast(cells->GetAbstractArray(vtkDataSetAttributes::GhostArrayName()));
  if (marks && marks->GetNumberOfValues() == centers->GetNumberOfPoints())
  {
    TakeMarks(marks, centers);
  }
  centers->SetFieldData(image->GetFieldData());
  return centers;
}

vtkSmartPointer<vtkImageData> InkWithPointValues(vtkImageData* image, const std::string& array)
{
  return InkTakesCells(image, array) ? InkAtCellCenters(image)
    : array.empty()                  ? InkWithActiveScalars(image)
                                     : vtkSmartPointer<vtkImageData>(image);
}

InkPointInput::InkPointInput() = default;

InkPointInput::~InkPointInput() = default;

vtkInformationVector** InkPointInput::Take(vtkAlgorithm* filter, vtkInformationVector** input, int port)
{
  vtkInformation* info = input[port]->GetInformationObject(0);
  vtkImageData* image = info ? vtkImageData::GetData(info) : nullptr;
  const std::string array = NameOfChosen(filter);
  const bool takesCells = image && InkTakesCells(image, array);
  if (!takesCells && !(image && array.empty() && InkLacksActiveScalars(image)))
  {
    this->Made = nullptr;
    return input;
  }
  if (!this->Made || this->From != image || this->Array != array || this->Time != image->GetMTime())
  {
    this->Made = InkWithPointValues(image, array);
    this->From = image;
    this->Array = array;
    this->Time = image->GetMTime();
  }
  vtkNew<vtkInformation> replaced;
  // Not all of it: the keys of the pipeline would keep its filters alive.
  replaced->Set(vtkDataObject::DATA_OBJECT(), this->Made);
  using SDDP = vtkStreamingDemandDrivenPipeline;
  if (info->Has(SDDP::WHOLE_EXTENT()))
  {
    int whole[6];
    info->Get(SDDP::WHOLE_EXTENT(), whole);
    if (takesCells)
    {
      InkToCellExtent(whole);
    }
    replaced->Set(SDDP::WHOLE_EXTENT(), whole, 6);
  }
  this->Replaced = vtkSmartPointer<vtkInformationVector>::New();
  this->Replaced->Append(replaced);
  this->All.assign(input, input + filter->GetNumberOfInputPorts());
  this->All[static_cast<std::size_t>(port)] = this->Replaced;
  return this->All.data();
}

int InkPointInput::GetGhostLevels(vtkAlgorithm* filter, vtkInformation* input)
{
  const std::string array = NameOfChosen(filter);
  vtkImageData* image = vtkImageData::GetData(input);
  return InkAnnouncesCells(input, array) || (image && InkTakesCells(image, array)) ? 1 : 0;
}
