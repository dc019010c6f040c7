// SPDX-License-Identifier: BSD-3-Clause
// All styles draw images that have values in their cells as those of the cells' centers: images themselves,
// in composite data, and from a port as ParaView's are.
#include "StyleData.h"
#include "StyleErrors.h"

#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkInkStippleStyle.h"
#include "vtkInkStyle.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{

/// The ball's values in cells around its points.
vtkSmartPointer<vtkImageData> MakeBallOfCells()
{
  const auto points = MakeBall();
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(17, 17, 17);
  image->SetOrigin(-0.5, -0.5, -0.5);
  image->GetCellData()->SetScalars(points->GetPointData()->GetScalars());
  return image;
}

} // namespace

TEST(StylesOfCells, DrawWhatIsDrawnOfTheCellsCenters)
{
  const auto ball = MakeBallOfCells();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, ball);
  for (const auto& style : MakeStyles())
  {
    style->SetPictureSize(100.0);
    EXPECT_EQ(style->GetReasonAgainst(ball), "") << style->GetName();
    ASSERT_TRUE(style->Make(MakeBall())) << style->GetName();
    const std::vector<double> expected = MarksOf(style);
    ASSERT_GT(expected.size(), 300u) << style->GetName();
    ASSERT_TRUE(style->Make(ball)) << style->GetName();
    EXPECT_TRUE(MarksOf(style) == expected) << style->GetName() << ": " << MarksOf(style).size();
    ASSERT_TRUE(style->Make(blocks)) << style->GetName();
    EXPECT_GT(CountOf(style), 0) << style->GetName();
  }
}

TEST(StylesOfCells, FromAPortAsFromItself)
{
  const auto ball = MakeBall();
  const auto ofCells = MakeBallOfCells();
  for (const auto& style : MakeStyles())
  {
    style->SetPictureSize(100.0);
    std::vector<double> marks[2];
    for (const bool cells : { false, true })
    {
      vtkNew<vtkTrivialProducer> producer;
      vtkImageData* image = cells ? ofCells : ball;
      producer->SetOutput(image);
      EXPECT_EQ(style->MakeMarks({ .Data = image, .Port = producer->GetOutputPort() }), "")
        << style->GetName();
      marks[cells] = MarksOf(style);
    }
    EXPECT_FALSE(marks[0].empty()) << style->GetName();
    EXPECT_TRUE(marks[0] == marks[1])
      << style->GetName() << ": " << marks[0].size() << ' ' << marks[1].size();
  }
}

TEST(StylesOfCells, AnArrayOfCellsIsTakenByItsName)
{
  const auto both = MakeBallOfCells();
  vtkNew<vtkUnsignedCharArray> points;
  points->SetName("points");
  points->SetNumberOfValues(both->GetNumberOfPoints());
  points->FillValue(7);
  both->GetPointData()->SetScalars(points);
  vtkNew<vtkInkStippleStyle> stipple;
  stipple->SetStippleSource(vtkInkStippleStyle::VOXELS);
  ASSERT_TRUE(stipple->Make(both));
  EXPECT_EQ(CountOf(stipple), 0) << "nothing in the points' array";
  stipple->SetParameterAsString("Scalars", "density");
  ASSERT_TRUE(stipple->Make(both));
  const vtkIdType found = CountOf(stipple);
  stipple->SetParameterAsString("Scalars", "");
  ASSERT_TRUE(stipple->Make(MakeBall()));
  EXPECT_EQ(found, CountOf(stipple));
}
