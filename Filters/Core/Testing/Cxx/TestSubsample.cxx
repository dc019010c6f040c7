// SPDX-License-Identifier: BSD-3-Clause
// Some of an image's points: where they stand, and what they have.
#include "InkSubsample.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <array>

namespace
{

vtkSmartPointer<vtkImageData> MakeImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(-2, 6, 3, 9, 1, 5);
  image->SetSpacing(0.5, 2.0, 1.5);
  image->SetOrigin(1.0, -2.0, 3.0);
  image->SetDirectionMatrix(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
  vtkNew<vtkDoubleArray> places;
  places->SetName("places");
  places->SetNumberOfComponents(3);
  places->SetComponentName(1, "y");
  vtkNew<vtkSOADataArrayTemplate<short>> ids;
  ids->SetName("ids");
  ids->SetNumberOfComponents(1);
  vtkNew<vtkStringArray> texts;
  texts->SetName("texts");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    places->InsertNextTuple(image->GetPoint(i));
    ids->InsertNextValue(static_cast<short>(i));
    texts->InsertNextValue("text");
  }
  image->GetPointData()->AddArray(places);
  image->GetPointData()->AddArray(texts);
  image->GetPointData()->SetScalars(ids);
  return image;
}

} // namespace

TEST(Subsample, PointsStandWhereTheyStood)
{
  const auto image = MakeImage();
  const std::array<InkSubsampledAxis, 3> axes = { { { { 1, 4, 7 }, 1.0, 3.0 }, { { 0, 6 }, 0.0, 6.0 },
    { { 0, 1, 2, 3, 4 }, 0.0, 1.0 } } };
  const auto some = InkSubsample(image, axes);
  ASSERT_EQ(some->GetNumberOfPoints(), 3 * 2 * 5);
  vtkPointData* points = some->GetPointData();
  ASSERT_EQ(points->GetNumberOfArrays(), 2) << "numbers alone";
  ASSERT_TRUE(points->GetScalars());
  EXPECT_STREQ(points->GetScalars()->GetName(), "ids");
  EXPECT_EQ(points->GetScalars()->GetDataType(), VTK_SHORT);
  EXPECT_STREQ(points->GetArray("places")->GetComponentName(1), "y");
  for (vtkIdType i = 0; i < some->GetNumberOfPoints(); ++i)
  {
    double place[3];
    double expected[3];
    some->GetPoint(i, place);
    points->GetArray("places")->GetTuple(i, expected);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(place[axis], expected[axis], 1e-12) << i;
    }
    image->GetPoint(static_cast<vtkIdType>(points->GetScalars()->GetTuple1(i)), expected);
    EXPECT_NEAR(place[0], expected[0], 1e-12) << i;
  }
}

TEST(Subsample, BetweenPointsWhereThatIsSaid)
{
  const auto image = MakeImage();
  const std::array<InkSubsampledAxis, 3> axes = { { { { 1, 3 }, 0.5, 2.0 }, { { 2 }, 2.0, 1.0 },
    { { 4 }, 4.0, 1.0 } } };
  const auto some = InkSubsample(image, axes);
  double place[3];
  double expected[3];
  some->GetPoint(1, place);
  image->TransformContinuousIndexToPhysicalPoint(0.5, 5.0, 5.0, expected);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(place[axis], expected[axis], 1e-12);
  }
  EXPECT_EQ(some->GetPointData()->GetScalars()->GetTuple1(1), 3 + 9 * (2 + 7 * 4));
}

TEST(Subsample, ArraysThatAreTooShortAreLeftOut)
{
  const auto image = MakeImage();
  vtkNew<vtkDoubleArray> little;
  little->SetName("little");
  little->SetNumberOfTuples(3);
  image->GetPointData()->AddArray(little);
  const std::array<InkSubsampledAxis, 3> axes = { { { { 0, 8 }, 0.0, 8.0 }, { { 6 }, 6.0, 1.0 },
    { { 4 }, 4.0, 1.0 } } };
  const auto some = InkSubsample(image, axes);
  EXPECT_EQ(some->GetNumberOfPoints(), 2);
  EXPECT_FALSE(some->GetPointData()->HasArray("little"));
  EXPECT_EQ(some->GetPointData()->GetNumberOfArrays(), 2);
}

TEST(Subsample, CellsAreThoseInTheMiddle)
{
  const auto image = MakeImage();
  vtkNew<vtkDoubleArray> middles;
  middles->SetName("middles");
  middles->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < image->GetNumberOfCells(); ++i)
  {
    double box[6];
    image->GetCellBounds(i, box);
    middles->InsertNextTuple3(0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]), 0.5 * (box[4] + box[5]));
  }
  image->GetCellData()->AddArray(middles);
  const std::array<InkSubsampledAxis, 3> axes = { { { { 0, 3, 6 }, 0.0, 3.0 }, { { 6 }, 6.0, 1.0 },
    { { 0, 1, 2, 3, 4 }, 0.0, 1.0 } } };
  const auto some = InkSubsample(image, axes);
  vtkDataArray* taken = some->GetCellData()->GetArray("middles");
  ASSERT_TRUE(taken);
  ASSERT_EQ(taken->GetNumberOfTuples(), 2 * 4);
  ASSERT_EQ(some->GetNumberOfCells(), 2 * 4);
  // 0 to 3 has its middle in the second cell, 3 to 6 in the fifth; of y there is the last alone.
  for (int z = 0; z < 4; ++z)
  {
    for (int x = 0; x < 2; ++x)
    {
      double expected[3];
      image->GetCellData()->GetArray("middles")->GetTuple(1 + 3 * x + 8 * (5 + 6 * z), expected);
      double found[3];
      taken->GetTuple(x + 2 * z, found);
      EXPECT_EQ(std::to_array(found), std::to_array(expected)) << x << ", " << z;
    }
  }
}
