// SPDX-License-Identifier: BSD-3-Clause
// Illustrations: lines and stipples on one surface, and one surface seen through another.
#include "StyleData.h"
#include "StyleErrors.h"

#include "vtkInkIllustrationStyle.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkInkSplattingLinesStyle.h"
#include "vtkInkStippleMapper.h"
#include "vtkInkStippleStyle.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

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

/// Each element's position, one of its stipples', and what it is colored by; empty if it is not.
std::vector<std::pair<std::array<double, 3>, double>> ColorsOf(vtkInkIllustrationStyle* style)
{
  vtkPolyData* stipples = style->GetPiece(style->GetColoredPiece());
  vtkDataArray* colors = stipples->GetCellData()->GetScalars();
  std::vector<std::pair<std::array<double, 3>, double>> found;
  for (vtkIdType i = 0; colors && i < stipples->GetNumberOfCells(); ++i)
  {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    stipples->GetCellPoints(i, count, points);
    if (count > 0)
    {
      std::array<double, 3> p;
      stipples->GetPoint(points[0], p.data());
      found.emplace_back(p, colors->GetComponent(i, 0));
    }
  }
  return found;
}

/// How far colors are from x.
double DistanceFromX(vtkInkIllustrationStyle* style)
{
  const auto colors = ColorsOf(style);
  double greatest = colors.empty() ? std::numeric_limits<double>::infinity() : 0.0;
  for (const auto& [position, color] : colors)
  {
    greatest = std::max(greatest, std::abs(color - position[0]));
  }
  return greatest;
}

constexpr double FewStipples = 20000.0;

/// A point array of x.
void AddPositions(vtkDataSet* data)
{
  vtkNew<vtkFloatArray> x;
  x->SetName("x");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    x->InsertNextValue(static_cast<float>(data->GetPoint(i)[0]));
  }
  data->GetPointData()->AddArray(x);
}

TEST(IllustrationStyle, StipplesAreColoredByAnArrayAndLinesStayInk)
{
  const auto image = MakeBall();
  const auto mesh = MakeMesh();
  for (vtkDataSet* data : { static_cast<vtkDataSet*>(image), static_cast<vtkDataSet*>(mesh) })
  {
    AddPositions(data);
    vtkNew<vtkInkIllustrationStyle> style;
    style->SetParameter("NumberOfSurfaceStipples", FewStipples);
    style->SetParameterAsString("ColorMap", "viridis");
    style->SetParameterAsString("ColorBy", "x");
    ASSERT_TRUE(style->Draw(data));
    EXPECT_TRUE(style->GetColorByScalars());
    EXPECT_FALSE(style->GetLinesStyle()->GetColorByScalars());
    // A stipple lies anywhere on a disc of the image's surface, that has one value.
    EXPECT_LT(DistanceFromX(style), data == image ? 0.6 : 0.05) << data->GetClassName();
    style->SetParameterAsString("ColorMap", "");
    ASSERT_TRUE(style->Draw(data));
    EXPECT_FALSE(style->GetColorByScalars());

    // As ParaView asks for it.
    vtkNew<vtkInkIllustrationStyle> interactive;
    interactive->InteractiveOn();
    interactive->SetParameter("NumberOfSurfaceStipples", FewStipples);
    ASSERT_TRUE(interactive->Make(data));
    EXPECT_GT(DistanceFromX(interactive), 1.0);
    interactive->SetColorArray("x", vtkDataObject::FIELD_ASSOCIATION_POINTS);
    ASSERT_TRUE(interactive->Make(data));
    EXPECT_LT(DistanceFromX(interactive), data == image ? 0.6 : 0.05) << data->GetClassName();
  }
}

TEST(IllustrationStyle, ScalarsWithoutANameColorAndPointsDo)
{
  const auto image = MakeBall();
  image->GetPointData()->GetScalars()->SetName(nullptr);
  vtkNew<vtkInkIllustrationStyle> style;
  style->SetParameter("NumberOfSurfaceStipples", FewStipples);
  style->SetParameterAsString("ColorMap", "viridis");
  style->SetParameterAsString("IsoValues", "100");
  ASSERT_TRUE(style->Draw(image));
  const auto colors = ColorsOf(style);
  ASSERT_FALSE(colors.empty());
  for (const auto& [position, color] : colors)
  {
    EXPECT_NEAR(color, 100.0, 10.0);
  }
  const auto cloud = MakeCloud();
  AddPositions(cloud);
  vtkNew<vtkInkIllustrationStyle> interactive;
  interactive->InteractiveOn();
  interactive->SetColorArray("x", vtkDataObject::FIELD_ASSOCIATION_POINTS);
  ASSERT_TRUE(interactive->Make(cloud));
  EXPECT_LT(DistanceFromX(interactive), 0.3);
}

TEST(IllustrationStyle, VolumesInPartsHaveNoColors)
{
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(MakeBall());
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputConnection(producer->GetOutputPort());
  vtkNew<vtkInkIllustrationStyle> style;
  EXPECT_TRUE(style->DrawSurfaces(sampler));
  style->SetParameterAsString("ColorMap", "viridis");
  const StyleErrors errors(style);
  EXPECT_FALSE(style->DrawSurfaces(sampler));
  ASSERT_EQ(errors.All.size(), 1u);
  EXPECT_NE(errors.All[0].find("ColorMap needs the whole volume"), std::string::npos) << errors.All[0];
}

TEST(IllustrationStyle, AnArrayToColorByHasToBeThere)
{
  vtkNew<vtkInkIllustrationStyle> style;
  style->SetParameterAsString("ColorMap", "viridis");
  style->SetParameterAsString("ColorBy", "pressure");
  const StyleErrors errors(style);
  EXPECT_FALSE(style->Make(MakeBall()));
  ASSERT_EQ(errors.All.size(), 1u);
  EXPECT_NE(errors.All[0].find("'pressure' to color by (point arrays: 'density')"), std::string::npos)
    << errors.All[0];
}

TEST(IllustrationStyle, LabelsColorTheirOwnRegion)
{
  const auto labels = MakeBall(40);
  vtkDataArray* values = labels->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < labels->GetNumberOfPoints(); ++i)
  {
    double p[3];
    labels->GetPoint(i, p);
    const bool inside = std::hypot(p[0] - 19.5, p[1] - 19.5, p[2] - 19.5) < 15.0;
    values->SetComponent(i, 0, !inside ? 0.0 : p[0] < 19.5 ? 3.0 : 90.0);
  }
  vtkNew<vtkInkIllustrationStyle> style;
  style->SetParameter("NumberOfSurfaceStipples", FewStipples);
  style->SetParameterAsString("ColorMap", "red,blue");
  const auto expectColors = [&](double low, double high)
  {
    ASSERT_TRUE(style->Draw(labels));
    const auto colors = ColorsOf(style);
    ASSERT_FALSE(colors.empty());
    for (const auto& [position, color] : colors)
    {
      const bool isNear = std::abs(position[0] - 19.5) < 1.5;
      EXPECT_TRUE(isNear ? color == low || color == high : color == (position[0] < 19.5 ? low : high))
        << color << " at " << position[0];
    }
  };
  expectColors(0.0, 1.0);
  style->SetParameterAsString("ColorRange", "0,100");
  expectColors(3.0, 90.0);
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
