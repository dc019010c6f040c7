// SPDX-License-Identifier: BSD-3-Clause
// Illustrations: lines and stipples on one surface, and one surface seen through another.
#include "StyleData.h"
#include "StyleErrors.h"

#include "vtkInkIllustrationStyle.h"
#include "vtkInkStippleMapper.h"
#include "vtkInkStippleStyle.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace
{

TEST(IllustrationStyle, IllustrationsPutBothOnOneSurface)
{
  vtkNew<vtkInkIllustrationStyle> style;
  EXPECT_TRUE(style->Accepts(MakeCloud()));
  for (const vtkSmartPointer<vtkDataObject>& data : { vtkSmartPointer<vtkDataObject>(MakeBall()),
         vtkSmartPointer<vtkDataObject>(MakeMesh()), vtkSmartPointer<vtkDataObject>(MakeCloud()) })
  {
    ASSERT_TRUE(style->Draw(data));
    EXPECT_GT(style->GetPiece(0)->GetNumberOfPoints(), 50);
    EXPECT_GT(style->GetPiece(2)->GetNumberOfPoints(), 1000);
    EXPECT_EQ(
      style->GetPiece(2)->GetNumberOfPoints(), style->GetStippleStyle()->GetPiece(0)->GetNumberOfPoints());
    EXPECT_EQ(style->GetActor()->GetMapper(), style->GetMapper());
    double lines[6];
    double stipples[6];
    style->GetPiece(0)->GetBounds(lines);
    style->GetPiece(2)->GetBounds(stipples);
    const double size = lines[1] - lines[0];
    for (int i = 0; i < 6; ++i)
    {
      EXPECT_NEAR(lines[i], stipples[i], 0.05 * size) << data->GetClassName();
    }
  }
  EXPECT_STREQ(style->GetPieceName(0), "Points");
  EXPECT_STREQ(style->GetPieceName(1), "Silhouettes' surface");
  EXPECT_STREQ(style->GetPieceName(2), "Stipples");
  EXPECT_STREQ(style->GetPieceName(5), "Outer points");
  // Light ink shows light.
  style->SetParameterAsString("InkColor", "white");
  style->SetParameterAsString("PaperColor", "black");
  EXPECT_TRUE(style->GetStippleStyle()->GetStippleMapper()->GetLightInk());
  double paper[3];
  style->GetBackgroundColor(paper);
  EXPECT_EQ(paper[0], 0.0);
}

/// Two materials, the one around the other, blurred as a scanner does.
vtkSmartPointer<vtkImageData> MakeNested(int side = 40)
{
  const auto image = MakeBall(side);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    const double middle = (side - 1) / 2.0;
    const double r = std::hypot(p[0] - middle, p[1] - middle, p[2] - middle) / side;
    const auto step = [&](double radius) { return 1.0 / (1.0 + std::exp((r - radius) * 2.0 * side)); };
    values->SetComponent(i, 0, 60.0 * step(0.4) + 120.0 * step(0.2));
  }
  return image;
}

double LargestRadius(vtkPolyData* points, const double center[3])
{
  double largest = 0.0;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    largest = std::max(largest, std::sqrt(vtkMath::Distance2BetweenPoints(p, center)));
  }
  return largest;
}

TEST(IllustrationStyle, SeeThroughHasASurfaceAroundAnother)
{
  constexpr int outer = 5;
  const auto image = MakeNested();
  vtkNew<vtkInkIllustrationStyle> style;
  ASSERT_TRUE(style->Draw(image));
  ASSERT_EQ(style->GetNumberOfPieces(), 2 * outer);
  EXPECT_EQ(style->GetPieceName(2 * outer), nullptr);
  EXPECT_NEAR(LargestRadius(style->GetPiece(0), image->GetCenter()), 16, 0.5);
  for (int piece = outer; piece < 2 * outer; ++piece)
  {
    EXPECT_EQ(style->GetPiece(piece)->GetNumberOfPoints(), 0) << style->GetPieceName(piece);
  }
  EXPECT_FALSE(style->GetMapper()->HasTranslucentPolygonalGeometry());
  double alone[6];
  style->GetActor()->GetBounds(alone);

  style->SetParameter("SeeThrough", 1);
  ASSERT_TRUE(style->Draw(image));
  EXPECT_NEAR(LargestRadius(style->GetPiece(0), image->GetCenter()), 8, 0.5);
  EXPECT_NEAR(LargestRadius(style->GetPiece(outer), image->GetCenter()), 16, 0.5);
  EXPECT_GT(style->GetPiece(outer + 2)->GetNumberOfPoints(), 10000);
  ASSERT_EQ(style->GetNumberOfNotes(), 2);
  EXPECT_EQ(std::string(style->GetNote(0)).find("outer iso-value "), 0u);
  EXPECT_EQ(std::string(style->GetNote(1)).find("inner iso-value "), 0u);
  // What was chosen is no parameter, and the frame is around both.
  EXPECT_EQ(style->GetParameterAsString("IsoValues"), "");
  EXPECT_EQ(style->GetFramePoints(), style->GetPiece(outer)->GetPoints());
  EXPECT_TRUE(style->GetMapper()->HasOpaqueGeometry());
  EXPECT_TRUE(style->GetMapper()->HasTranslucentPolygonalGeometry());
  double both[6];
  style->GetActor()->GetBounds(both);
  EXPECT_NEAR(both[0], alone[0], 0.5);

  // One of the values, or both, can be given.
  style->SetParameter("IsoValues", 150);
  ASSERT_TRUE(style->Make(image));
  EXPECT_EQ(style->GetNumberOfNotes(), 1);
  const double inner = LargestRadius(style->GetPiece(0), image->GetCenter());
  EXPECT_LT(inner, 7.9);
  style->SetParameter("OuterIsoValue", 100);
  ASSERT_TRUE(style->Make(image));
  EXPECT_EQ(style->GetNumberOfNotes(), 0);
  EXPECT_EQ(LargestRadius(style->GetPiece(0), image->GetCenter()), inner);
  EXPECT_NEAR(LargestRadius(style->GetPiece(outer), image->GetCenter()), 8.3, 0.4);
  style->SetParameter("SeeThrough", 0);
  ASSERT_TRUE(style->Draw(image));
  EXPECT_EQ(style->GetPiece(outer)->GetNumberOfPoints(), 0);
  EXPECT_FALSE(style->GetMapper()->HasTranslucentPolygonalGeometry());
}

TEST(IllustrationStyle, SeeThroughNeedsTwoBoundaries)
{
  vtkNew<vtkInkIllustrationStyle> style;
  style->SetParameter("SeeThrough", 1);
  const StyleErrors errors(style);
  EXPECT_FALSE(style->Draw(MakeBall()));
  ASSERT_EQ(errors.All.size(), 1u);
  EXPECT_NE(errors.All[0].find("two clear boundaries"), std::string::npos) << errors.All[0];
  // Of a mesh there is one surface.
  EXPECT_TRUE(style->Draw(MakeMesh()));
  EXPECT_GT(CountOf(style), 0);
}

} // namespace
