// SPDX-License-Identifier: BSD-3-Clause
// Lines without polygons, as center lines and fiber tracts are: drawn as tubes in all styles.

#include "InkSourcePoints.h"
#include "InkTubes.h"
#include "StyleData.h"
#include "StyleErrors.h"
#include "vtkInkContoursStyle.h"
#include "vtkInkIllustrationStyle.h"
#include "vtkInkLineArtStyle.h"
#include "vtkInkSplattingLinesStyle.h"
#include "vtkInkStippleStyle.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkLine.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <string>

namespace
{

/// Around the z axis, in a distance of 1, from z = 0 to 2.
/// @param segments whether each two points are a line; or else all are one
vtkSmartPointer<vtkPolyData> MakeHelix(bool segments)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  const int count = 100;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 0.15 * i;
    const vtkIdType point = points->InsertNextPoint(std::cos(angle), std::sin(angle), 2.0 * i / (count - 1));
    if (segments && i > 0)
    {
      lines->InsertNextCell({ point - 1, point });
    }
  }
  if (!segments)
  {
    lines->InsertNextCell(count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      lines->InsertCellPoint(i);
    }
  }
  auto helix = vtkSmartPointer<vtkPolyData>::New();
  helix->SetPoints(points);
  helix->SetLines(lines);
  return helix;
}

/// How far marks are from the axis.
std::array<double, 2> RangeOfDistances(vtkPolyData* marks)
{
  std::array<double, 2> range{ HUGE_VAL, 0.0 };
  for (vtkIdType i = 0; i < marks->GetNumberOfPoints(); ++i)
  {
    const double* p = marks->GetPoint(i);
    const double distance = std::hypot(p[0], p[1]);
    range = { std::min(range[0], distance), std::max(range[1], distance) };
  }
  return range;
}

} // namespace

TEST(StylesOfLines, AllStylesDrawTubes)
{
  vtkNew<vtkInkSplattingLinesStyle> lines;
  vtkNew<vtkInkStippleStyle> stipples;
  vtkNew<vtkInkIllustrationStyle> illustration;
  vtkNew<vtkInkContoursStyle> contours;
  vtkNew<vtkInkLineArtStyle> lineArt;
  for (vtkInkStyle* style :
    std::initializer_list<vtkInkStyle*>{ lines, stipples, illustration, contours, lineArt })
  {
    MakeFewMarks(style);
    for (const bool segments : { false, true })
    {
      ASSERT_TRUE(style->Make(MakeHelix(segments))) << style->GetName();
      ASSERT_GT(CountOf(style), 50) << style->GetName();
      ASSERT_GE(style->GetNumberOfNotes(), 1);
      EXPECT_NE(std::string(style->GetNote(0)).find("tubes of radius 0.01"), std::string::npos)
        << style->GetNote(0);
    }
  }
  const auto [least, most] = RangeOfDistances(lines->GetPiece(0));
  const double radius = 0.003 * MakeHelix(false)->GetLength();
  EXPECT_NEAR(least, 1.0 - radius, 0.3 * radius);
  EXPECT_NEAR(most, 1.0 + radius, 0.3 * radius);
}

TEST(StylesOfLines, AnArrayOfRadiiIsFollowed)
{
  for (const char* name : { "Radius", "MaximumInscribedSphereRadius", "thickness" })
  {
    const auto helix = MakeHelix(false);
    vtkNew<vtkDoubleArray> radii;
    radii->SetName(name);
    for (vtkIdType i = 0; i < helix->GetNumberOfPoints(); ++i)
    {
      radii->InsertNextValue(0.1);
    }
    helix->GetPointData()->AddArray(radii);
    vtkNew<vtkInkSplattingLinesStyle> style;
    MakeFewMarks(style);
    ASSERT_TRUE(style->Make(helix));
    const bool isKnown = std::string(name) != "thickness";
    EXPECT_NEAR(RangeOfDistances(style->GetPiece(0))[0], isKnown ? 0.9 : 0.99, isKnown ? 0.01 : 0.005)
      << name;
    radii->SetValue(7, -1.0);
    radii->Modified();
    ASSERT_TRUE(style->Make(helix));
    EXPECT_NEAR(RangeOfDistances(style->GetPiece(0))[0], 0.99, 0.005) << "some are below 0";
  }
}

TEST(StylesOfLines, PointsThatCoincideAndLinesWithoutLength)
{
  const auto helix = MakeHelix(false);
  vtkPoints* points = helix->GetPoints();
  points->SetPoint(11, points->GetPoint(10));
  const vtkIdType point = points->InsertNextPoint(0.0, 0.0, 0.0);
  helix->GetLines()->InsertNextCell({ point, point });
  vtkNew<vtkInkIllustrationStyle> style;
  MakeFewMarks(style);
  const StyleErrors errors(style);
  ASSERT_TRUE(style->Make(helix));
  EXPECT_GT(CountOf(style), 1000);
  EXPECT_TRUE(errors.All.empty()) << errors.All.front();
  // Nothing else is left.
  vtkNew<vtkPolyData> none;
  none->SetPoints(points);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ point, point });
  none->SetLines(lines);
  vtkNew<vtkInkSplattingLinesStyle> splats;
  EXPECT_TRUE(splats->Make(none));
  EXPECT_EQ(CountOf(splats), 0);
  ASSERT_GE(splats->GetNumberOfNotes(), 1);
  EXPECT_STREQ(splats->GetNote(0), "nothing to draw: the lines have no length");
}

TEST(StylesOfLines, TubesGoAlongTheLinesAlone)
{
  // Back and forth, a ring with a line that ends on it, a point that is not finite, and normals along lines.
  vtkNew<vtkPoints> points;
  for (const auto& [x, y, z] : { std::array{ 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.5, 0.0, 0.0 },
         { 0.0, 1.0, 0.0 }, { 1.0, 2.0, 0.0 }, { NAN, 0.0, 0.0 }, { 5.0, 5.0, 1.0 } })
  {
    points->InsertNextPoint(x, y, z);
  }
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1, 2 });
  lines->InsertNextCell({ 0, 1, 3, 0 });
  lines->InsertNextCell({ 4, 3 });
  lines->InsertNextCell({ 5, 4 });
  vtkNew<vtkPolyData> given;
  given->SetPoints(points);
  given->SetLines(lines);
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    normals->InsertNextTuple3(1.0, 0.0, 0.0);
  }
  given->GetPointData()->SetNormals(normals);
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("line");
  for (int i = 0; i < 4; ++i)
  {
    numbers->InsertNextValue(i);
  }
  for (const bool ofCells : { false, true })
  {
    if (ofCells)
    {
      given->GetCellData()->AddArray(numbers);
    }
    std::string note;
    const vtkSmartPointer<vtkPolyData> tubes = InkMakeTubes(given, note);
    ASSERT_GT(tubes->GetNumberOfPolys(), 100);
    const double radius = 0.003 * std::hypot(1.0, 2.0);
    EXPECT_NE(note.find("0.0067"), std::string::npos) << note << ": the unused point is far away";
    const double ends[4][6] = { { 0, 0, 0, 1, 0, 0 }, { 1, 0, 0, 0, 1, 0 }, { 0, 1, 0, 0, 0, 0 },
      { 0, 1, 0, 1, 2, 0 } };
    std::array<int, 4> along{};
    vtkIdTypeArray* sources = InkGetSourcePoints(tubes);
    ASSERT_TRUE(sources);
    for (vtkIdType i = 0; i < tubes->GetNumberOfPoints(); ++i)
    {
      double p[3];
      tubes->GetPoint(i, p);
      double least = HUGE_VAL;
      for (std::size_t n = 0; n < 4; ++n)
      {
        double t;
        double closest[3];
        const double distance = std::sqrt(vtkLine::DistanceToLine(p, ends[n], ends[n] + 3, t, closest));
        along[n] += distance < 1.1 * radius ? 1 : 0;
        least = std::min(least, distance);
      }
      EXPECT_LT(least, 2.7 * radius) << "also at the mitered corners";
      EXPECT_LT(
        std::sqrt(vtkMath::Distance2BetweenPoints(p, points->GetPoint(sources->GetValue(i)))), 2.7 * radius);
    }
    EXPECT_GT(*std::min_element(along.begin(), along.end()), 15);
    vtkDataArray* ofLines = tubes->GetCellData()->GetArray("line");
    ASSERT_EQ(ofLines != nullptr, ofCells);
    if (ofCells)
    {
      double range[2];
      ofLines->GetRange(range);
      EXPECT_EQ(range[0], 0.0);
      EXPECT_EQ(range[1], 2.0);
    }
  }
}
