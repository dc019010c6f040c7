// SPDX-License-Identifier: BSD-3-Clause
// Images of cells as images of points in the cells' centers: where these lie, whose values they have, and
// which of them are others' or hidden.

#include "InkCellCenters.h"
#include "InkImageGrid.h"

#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkDataSetAlgorithm.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>

namespace
{

vtkSmartPointer<vtkIntArray> Numbers(const char* name, vtkIdType count)
{
  auto numbers = vtkSmartPointer<vtkIntArray>::New();
  numbers->SetName(name);
  for (vtkIdType i = 0; i < count; ++i)
  {
    numbers->InsertNextValue(static_cast<int>(i));
  }
  return numbers;
}

/// Oblique, from an extent that does not begin at 0, with the numbers of its cells as `cells`.
vtkSmartPointer<vtkImageData> Image(std::array<int, 6> extent = { 2, 6, -3, 0, 5, 7 })
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(extent.data());
  image->SetSpacing(0.5, 2.0, 3.0);
  image->SetOrigin(10.0, -4.0, 1.0);
  image->SetDirectionMatrix(0.0, -1.0, 0.0, 0.6, 0.0, -0.8, 0.8, 0.0, 0.6);
  image->GetCellData()->AddArray(Numbers("cells", image->GetNumberOfCells()));
  return image;
}

/// The marks of an image's cells, by a function of their number.
void Mark(vtkImageData* image, const std::function<int(vtkIdType)>& marks)
{
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType i = 0; i < image->GetNumberOfCells(); ++i)
  {
    array->InsertNextValue(static_cast<unsigned char>(marks(i)));
  }
  image->GetCellData()->AddArray(array);
}

} // namespace

TEST(CellCenters, PointsAreWhereCellsHaveTheirMiddle)
{
  const auto image = Image();
  const vtkSmartPointer<vtkImageData> centers = InkAtCellCenters(image);
  ASSERT_EQ(centers->GetNumberOfPoints(), image->GetNumberOfCells());
  for (vtkIdType i = 0; i < image->GetNumberOfCells(); ++i)
  {
    double bounds[6];
    double sum[3] = {};
    vtkNew<vtkIdList> corners;
    image->GetCellPoints(i, corners);
    ASSERT_EQ(corners->GetNumberOfIds(), 8);
    for (const vtkIdType corner : *corners)
    {
      const double* p = image->GetPoint(corner);
      for (int axis = 0; axis < 3; ++axis)
      {
        sum[axis] += p[axis] / 8;
      }
    }
    centers->GetPoint(i, bounds);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(bounds[axis], sum[axis], 1e-12) << i;
    }
  }
}

TEST(CellCenters, ValuesAreTheCellsOwn)
{
  const auto image = Image();
  vtkDataArray* cells = image->GetCellData()->GetArray("cells");
  vtkDataArray* found = InkAtCellCenters(image)->GetPointData()->GetScalars();
  EXPECT_EQ(found, cells) << "no copy";
  const auto second = Numbers("second", image->GetNumberOfCells());
  image->GetCellData()->SetScalars(second);
  EXPECT_EQ(InkAtCellCenters(image)->GetPointData()->GetScalars(), second.Get()) << "the active one stays";
  EXPECT_FALSE(image->GetPointData()->GetScalars()) << "the image stays as it is";
}

TEST(CellCenters, AnAxisWithoutCellsStays)
{
  const auto image = Image({ 0, 4, 3, 3, 0, 2 });
  const vtkSmartPointer<vtkImageData> centers = InkAtCellCenters(image);
  const int* extent = centers->GetExtent();
  EXPECT_EQ(std::vector<int>(extent, extent + 6), (std::vector{ 0, 3, 3, 3, 0, 1 }));
  EXPECT_EQ(centers->GetNumberOfPoints(), image->GetNumberOfCells());
  double first[3];
  double expected[3];
  const double inCell[3] = { 0.5, 3.0, 0.5 };
  image->TransformContinuousIndexToPhysicalPoint(inCell, expected);
  centers->GetPoint(0, first);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(first[axis], expected[axis], 1e-12);
  }
}

TEST(CellCenters, ValuesOfPointsAreTakenWhereThereAreAny)
{
  const auto image = Image();
  EXPECT_TRUE(InkTakesCells(image));
  EXPECT_TRUE(InkTakesCells(image, "cells"));
  EXPECT_FALSE(InkTakesCells(image, "others"));
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  marks->SetNumberOfValues(image->GetNumberOfPoints());
  image->GetPointData()->AddArray(marks);
  EXPECT_TRUE(InkTakesCells(image)) << "marks are no values";
  image->GetPointData()->AddArray(Numbers("points", image->GetNumberOfPoints()));
  EXPECT_FALSE(InkTakesCells(image));
  EXPECT_TRUE(InkTakesCells(image, "cells")) << "asked for by its name";
  image->GetPointData()->SetActiveScalars("points");
  EXPECT_EQ(InkWithPointValues(image), image);
  image->GetPointData()->AddArray(Numbers("cells", image->GetNumberOfPoints()));
  EXPECT_FALSE(InkTakesCells(image, "cells"));
  vtkNew<vtkImageData> empty;
  EXPECT_FALSE(InkTakesCells(empty));
}

TEST(CellCenters, WhatIsMadeForOneArrayIsNotTakenForAnother)
{
  const auto image = Image();
  image->GetPointData()->AddArray(Numbers("points", image->GetNumberOfPoints()));
  vtkNew<vtkInformation> info;
  info->Set(vtkDataObject::DATA_OBJECT(), image);
  vtkNew<vtkInformationVector> inputs;
  inputs->Append(info);
  vtkInformationVector* input = inputs;
  vtkNew<vtkDataSetAlgorithm> filter;
  InkPointInput taker;
  const auto take = [&](const char* array)
  {
    filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array);
    return vtkImageData::GetData(taker.Take(filter, &input)[0]);
  };
  for (int n = 0; n < 2; ++n)
  {
    EXPECT_EQ(take("")->GetNumberOfPoints(), image->GetNumberOfPoints());
    vtkImageData* cells = take("cells");
    EXPECT_EQ(cells->GetNumberOfPoints(), image->GetNumberOfCells());
    EXPECT_EQ(take("cells"), cells) << "kept";
  }
}

TEST(CellCenters, ExtentsOfPointsAndCells)
{
  int extent[6] = { 2, 6, 3, 3, 5, 7 };
  const int whole[6] = { 0, 9, 3, 3, 0, 9 };
  InkToCellExtent(extent);
  EXPECT_EQ(std::vector<int>(extent, extent + 6), (std::vector{ 2, 5, 3, 3, 5, 6 }));
  InkToPointExtent(extent, whole);
  EXPECT_EQ(std::vector<int>(extent, extent + 6), (std::vector{ 2, 6, 3, 3, 5, 7 }));
  int nothing[6] = { 0, -1, 0, -1, 0, -1 };
  InkToPointExtent(nothing, whole);
  EXPECT_EQ(std::vector<int>(nothing, nothing + 6), (std::vector{ 0, -1, 0, -1, 0, -1 }));
}

TEST(CellCenters, MarksOfCellsAreThoseOfPointsAndOfTheCellsBetweenThem)
{
  using Marks = vtkDataSetAttributes;
  // 4 x 3 x 2 cells: those with x = 3 are another piece's, the first is hidden, those with x > 0 are refined.
  const auto image = Image();
  Mark(image,
    [](vtkIdType i)
    {
      const vtkIdType x = i % 4;
      return (x == 3 ? Marks::DUPLICATECELL : 0) | (i == 0 ? Marks::HIDDENCELL : 0) |
        (x > 0 ? Marks::REFINEDCELL : 0);
    });
  const vtkSmartPointer<vtkImageData> centers = InkAtCellCenters(image);
  vtkUnsignedCharArray* points = centers->GetPointGhostArray();
  vtkUnsignedCharArray* cells = centers->GetCellGhostArray();
  ASSERT_TRUE(points && cells);
  ASSERT_EQ(points->GetNumberOfValues(), 24);
  ASSERT_EQ(cells->GetNumberOfValues(), 3 * 2 * 1);
  for (vtkIdType i = 0; i < 24; ++i)
  {
    EXPECT_EQ(
      points->GetValue(i), (i % 4 == 3 ? Marks::DUPLICATEPOINT : 0) | (i == 0 ? Marks::HIDDENPOINT : 0))
      << i;
  }
  for (vtkIdType i = 0; i < 6; ++i)
  {
    // None of the cells between centers begins with one of the other piece's.
    EXPECT_EQ(cells->GetValue(i), i % 3 > 0 ? Marks::REFINEDCELL : 0) << i;
  }
  Mark(image, [](vtkIdType i) { return i % 4 < 2 ? int(Marks::DUPLICATECELL) : 0; });
  vtkUnsignedCharArray* others = InkAtCellCenters(image)->GetCellGhostArray();
  ASSERT_TRUE(others);
  EXPECT_EQ(InkAtCellCenters(image)->GetCellGhostArray()->GetValue(0), Marks::DUPLICATECELL);
  EXPECT_EQ(InkAtCellCenters(image)->GetCellGhostArray()->GetValue(1), Marks::DUPLICATECELL);
  EXPECT_EQ(InkAtCellCenters(image)->GetCellGhostArray()->GetValue(2), 0);
}

TEST(CellCenters, FramesAreKnownBeforeThereAreValues)
{
  const auto image = Image();
  vtkNew<vtkInformation> info;
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), image->GetExtent(), 6);
  info->Set(vtkDataObject::ORIGIN(), image->GetOrigin(), 3);
  info->Set(vtkDataObject::SPACING(), image->GetSpacing(), 3);
  EXPECT_FALSE(InkAnnouncesCells(info));
  EXPECT_EQ(InkMakePointFrame(info)->GetNumberOfPoints(), image->GetNumberOfPoints());

  vtkNew<vtkInformationVector> fields;
  vtkNew<vtkInformation> cells;
  cells->Set(vtkDataObject::FIELD_NAME(), "cells");
  fields->Append(cells);
  info->Set(vtkDataObject::CELL_DATA_VECTOR(), fields);
  EXPECT_TRUE(InkAnnouncesCells(info));
  EXPECT_TRUE(InkAnnouncesCells(info, "cells"));
  EXPECT_FALSE(InkAnnouncesCells(info, "others"));
  EXPECT_EQ(InkMakePointFrame(info)->GetNumberOfPoints(), image->GetNumberOfCells());
  EXPECT_EQ(InkMakeFrame(info)->GetNumberOfPoints(), image->GetNumberOfPoints());
  info->Set(vtkDataObject::POINT_DATA_VECTOR(), fields);
  EXPECT_FALSE(InkAnnouncesCells(info));
}
