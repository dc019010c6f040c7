// SPDX-License-Identifier: BSD-3-Clause
// The cells of points, and which points are ghosts.
#include "InkGhostPoint.h"
#include "InkPointOutput.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{

std::vector<std::vector<vtkIdType>> PointsOf(vtkCellArray* cells)
{
  std::vector<std::vector<vtkIdType>> points;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    cells->GetCellAtId(cell, size, ids);
    points.emplace_back(ids, ids + size);
  }
  return points;
}

} // namespace

TEST(PointOutput, PolyVerticesHoldAllPointsInOrder)
{
  using Cells = std::vector<std::vector<vtkIdType>>;
  const vtkIdType begins[] = { 0, 2, 2, 5 };
  EXPECT_EQ(PointsOf(InkMakePolyVertices(begins)), (Cells{ { 0, 1 }, {}, { 2, 3, 4 } }));
  EXPECT_EQ(PointsOf(InkMakePolyVertex(3)), (Cells{ { 0, 1, 2 } }));
  EXPECT_EQ(PointsOf(InkMakePolyVertex(0)), Cells());
}

TEST(PointOutput, IdsAreAsSmallAsTheyFit)
{
  EXPECT_EQ(InkFindIdType(0), VTK_TYPE_INT32);
  EXPECT_EQ(InkFindIdType(VTK_TYPE_INT32_MAX), VTK_TYPE_INT32);
  EXPECT_EQ(InkFindIdType(vtkIdType{ VTK_TYPE_INT32_MAX } + 1), VTK_TYPE_INT64);
  for (const int type : { VTK_TYPE_INT32, VTK_TYPE_INT64 })
  {
    const auto ids = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
    for (const vtkIdType count : { 4, 2 })
    {
      const auto cells = InkMakePolyVertex(count, ids);
      EXPECT_EQ(cells->GetConnectivityArray(), ids.Get()) << "kept";
      ASSERT_EQ(cells->GetNumberOfCells(), 1);
      EXPECT_EQ(cells->GetCellSize(0), count);
    }
  }
}

TEST(PointOutput, GhostsAreHiddenOrDuplicate)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  for (const int mark : { 0, static_cast<int>(vtkDataSetAttributes::HIDDENPOINT),
         static_cast<int>(vtkDataSetAttributes::DUPLICATEPOINT), 4 })
  {
    ghosts->InsertNextValue(static_cast<unsigned char>(mark));
  }
  for (vtkIdType point = 0; point < 6; ++point)
  {
    EXPECT_EQ(InkIsGhostPoint(ghosts, point), point == 1 || point == 2) << point;
    EXPECT_FALSE(InkIsGhostPoint(nullptr, point)) << point;
  }
}
