// SPDX-License-Identifier: BSD-3-Clause
// Styles of lines: hardness, width, thinning, speckles, dashes, colors by scalars and by tone, papers.
#include "InkTestImage.h"
#include "InkTestMessages.h"
#include "InkTestPoints.h"
#include "SplattingLinesScene.h"

#include "Core/Hash.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace
{

vtkSmartPointer<vtkPolyData> Torus()
{
  return InkTestPoints::Torus(1.0, 0.4, 0.02);
}

/// A torus whose normals are so noisy that there are speckles between its lines.
vtkSmartPointer<vtkPolyData> NoisyTorus()
{
  auto points = Torus();
  vtkDataArray* normals = points->GetPointData()->GetArray("Normals");
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double n[3];
    normals->GetTuple(i, n);
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto id = static_cast<std::uint64_t>(3 * i + axis);
      n[axis] += 0.5 * (ink::unitDouble(ink::hash(7, id)) - 0.5);
    }
    normals->SetTuple(i, n);
  }
  return points;
}

int CountGrays(const InkTestImage& image)
{
  int grays = 0;
  for (int y = 0; y < image.GetHeight(); ++y)
  {
    for (int x = 0; x < image.GetWidth(); ++x)
    {
      grays += image.Gray(x, y) > 20 && image.Gray(x, y) < 235;
    }
  }
  return grays;
}

/// Dark pixels that hang together by sides or corners.
int CountSpots(const InkTestImage& image)
{
  std::set<std::pair<int, int>> dark;
  for (int y = 0; y < image.GetHeight(); ++y)
  {
    for (int x = 0; x < image.GetWidth(); ++x)
    {
      if (image.IsDark(x, y))
      {
        dark.emplace(x, y);
      }
    }
  }
  int spots = 0;
  while (!dark.empty())
  {
    ++spots;
    std::vector<std::pair<int, int>> rest{ *dark.begin() };
    dark.erase(dark.begin());
    while (!rest.empty())
    {
      const auto [x, y] = rest.back();
      rest.pop_back();
      for (int i = 0; i < 9; ++i)
      {
        const std::pair<int, int> next(x + i % 3 - 1, y + i / 3 - 1);
        if (dark.erase(next) > 0)
        {
          rest.push_back(next);
        }
      }
    }
  }
  return spots;
}

} // namespace

TEST(SplattingLinesStyle, Hardness)
{
  SplattingLinesScene scene(Torus());
  scene.Mapper->SetPhi(40.0);
  int last = 1 << 30;
  for (double hardness : { 0.0, 0.5, 0.9, 1.0 })
  {
    scene.Mapper->SetHardness(hardness);
    const int grays = CountGrays(InkTestImage(scene.Window));
    EXPECT_TRUE(hardness == 1.0 ? grays <= last : grays < last)
      << "fewer grays with hardness " << hardness << ": " << grays << " after " << last;
    last = grays;
  }
  scene.Mapper->SetHardness(0.0);
  const int soft = InkTestImage(scene.Window).CountDark();
  scene.Mapper->SetHardness(1.0);
  const int hard = InkTestImage(scene.Window).CountDark();
  EXPECT_LT(std::abs(hard - soft), 0.1 * soft)
    << "lines that are hard as wide at half their ink: " << hard << ", " << soft;
}

TEST(SplattingLinesStyle, Width)
{
  SplattingLinesScene scene(Torus());
  double last = -1.0;
  for (double width : { -20.0, -10.0, -5.0, -2.5, 0.0, 2.5, 5.0, 10.0, 20.0 })
  {
    scene.Mapper->SetLineWidth(width);
    const double ink = InkTestImage(scene.Window).Ink();
    EXPECT_TRUE(ink > last || (ink == 0.0 && last == 0.0))
      << "more ink with width " << width << ": " << ink << " after " << last;
    last = ink;
  }
  // Twenty thousandths of 200 pixels: two on each side of the line.
  scene.Mapper->SetLineWidth(0.0);
  scene.Mapper->SetHardness(1.0);
  const auto width = [&scene]()
  {
    const InkTestImage image(scene.Window);
    int dark = 0;
    for (int x = 0; x < 60; ++x)
    {
      dark += image.IsDark(x, 100);
    }
    return dark;
  };
  const int plain = width();
  scene.Mapper->SetLineWidth(20.0);
  EXPECT_TRUE(plain > 0 && width() == plain + 4) << "four pixels more: " << width() << " after " << plain;
}

TEST(SplattingLinesStyle, Thinning)
{
  SplattingLinesScene scene(Torus());
  scene.Mapper->SetPhi(500.0);
  const InkTestImage whole(scene.Window);
  scene.Mapper->ThinningOn();
  const InkTestImage thin(scene.Window);
  EXPECT_LT(thin.Ink(), 0.75 * whole.Ink()) << "less ink: " << thin.Ink() << " of " << whole.Ink();
  int blocks = 0;
  int added = 0;
  for (int y = 0; y + 1 < 200; ++y)
  {
    for (int x = 0; x + 1 < 200; ++x)
    {
      blocks +=
        thin.IsDark(x, y) && thin.IsDark(x + 1, y) && thin.IsDark(x, y + 1) && thin.IsDark(x + 1, y + 1);
      added += thin.Gray(x, y) < whole.Gray(x, y);
    }
  }
  EXPECT_EQ(blocks, 0) << "no square of 2 x 2 dark pixels in thin lines, found " << blocks;
  EXPECT_EQ(added, 0) << "no ink where there was none, found " << added;
}

TEST(SplattingLinesStyle, Speckles)
{
  SplattingLinesScene scene(NoisyTorus());
  scene.Mapper->SetLambda(1.2);
  const InkTestImage noisy(scene.Window);
  double last = noisy.Ink();
  for (double length : { 4.0, 8.0, 16.0, 32.0 })
  {
    scene.Mapper->SetSpeckleLength(length);
    const InkTestImage image(scene.Window);
    EXPECT_TRUE(length > 8.0 ? image.Ink() <= last : image.Ink() < last)
      << "less ink without speckles of " << length << " pixels: " << image.Ink();
    last = image.Ink();
  }
  scene.Mapper->SetSpeckleLength(1000.0);
  EXPECT_EQ(InkTestImage(scene.Window).CountDark(250), 0) << "nothing is longer than the picture";
}

TEST(SplattingLinesStyle, Dashes)
{
  SplattingLinesScene scene(InkTestPoints::Sphere(1.0, 0.02));
  scene.Mapper->SetPhi(500.0);
  const double whole = InkTestImage(scene.Window).Ink();
  scene.Mapper->SetLayerDashLength(0, 40.0); // 8 pixels
  const InkTestImage dashed(scene.Window);
  const double share = dashed.Ink() / whole;
  EXPECT_TRUE(share > 0.4 && share < 0.65) << "about half of the ring in dashes: " << share;
  double radius = 0.0;
  for (int x = 100; x < 200; ++x)
  {
    radius = dashed.CountDark(x, 60, x + 1, 140) > 0 ? x - 100.0 : radius;
  }
  const double expected = 2.0 * vtkMath::Pi() * radius / 16.0;
  const int dashes = CountSpots(dashed);
  EXPECT_LT(std::abs(dashes - expected), 0.2 * expected)
    << "dashes and gaps of 8 pixels: " << dashes << " of " << expected;
}

TEST(SplattingLinesStyle, Scalars)
{
  auto points = Torus();
  vtkNew<vtkFloatArray> side;
  side->SetName("Side");
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    side->InsertNextValue(points->GetPoint(i)[0] > 0.0 ? 1.0f : 0.0f);
  }
  points->GetPointData()->SetScalars(side);
  SplattingLinesScene scene(points);
  const InkTestImage black(scene.Window);
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(2);
  table->SetTableValue(0, 1.0, 0.0, 0.0);
  table->SetTableValue(1, 0.0, 0.0, 1.0);
  scene.Mapper->SetLookupTable(table);
  scene.Mapper->SetScalarRange(0.0, 1.0);
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(black), 0)
    << "scalars color nothing unless they are to";
  scene.Mapper->SetInkColorMode(vtkInkSplattingLinesMapper::SCALARS);
  const InkTestImage colored(scene.Window);
  int wrong = 0;
  int lines = 0;
  for (int y = 0; y < 200; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      if (black.Gray(x, y) < 20 && std::abs(x - 100) > 4)
      {
        ++lines;
        wrong += colored.Channel(x, y, x < 100 ? 0 : 2) < 230 || colored.Channel(x, y, x < 100 ? 2 : 0) > 20;
      }
    }
  }
  EXPECT_TRUE(lines > 300 && wrong < lines / 100)
    << "red lines to the left, blue ones to the right; " << wrong << " of " << lines << " are not";
  const vtkMTimeType time = scene.Mapper->GetUploadTime();
  scene.Mapper->SetTau(1.0);
  scene.Mapper->InterpolateScalarsBeforeMappingOn();
  scene.Window->Render();
  EXPECT_EQ(scene.Mapper->GetUploadTime(), time) << "no upload of colors that do not change";
  scene.Mapper->SetTau(0.99);
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(colored), 0) << "points have no textures";
  // Wider lines, which reach beyond the surface, have their surface's color there, too.
  scene.Mapper->SetLineWidth(20.0);
  table->SetTableValue(0, 0.0, 1.0, 0.0);
  const InkTestImage wide(scene.Window);
  EXPECT_GT(scene.Mapper->GetUploadTime(), time) << "an upload of colors that did change";
  int red = 0;
  for (int y = 0; y < 200; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      red += wide.Channel(x, y, 0) > wide.Channel(x, y, 1) + 20 &&
        wide.Channel(x, y, 0) > wide.Channel(x, y, 2) + 20;
    }
  }
  EXPECT_EQ(red, 0) << "no color that the table does not have, found " << red << " pixels";
  scene.Mapper->SetLineWidth(0.0);
  scene.Mapper->ScalarVisibilityOff();
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(black), 0) << "no colors with ScalarVisibility off";

  // Scalars of cells say nothing about points.
  points->GetPointData()->SetScalars(nullptr);
  vtkNew<vtkFloatArray> cell;
  cell->SetName("Cell");
  cell->InsertNextValue(1.0f);
  vtkNew<vtkIdList> ids;
  ids->InsertNextId(0);
  points->AllocateExact(1, 1);
  points->InsertNextCell(VTK_VERTEX, ids);
  points->GetCellData()->SetScalars(cell);
  points->Modified();
  scene.Mapper->ScalarVisibilityOn();
  vtkNew<InkTestMessages> messages;
  messages->Observe(scene.Mapper);
  scene.Window->Render();
  scene.Window->Render();
  EXPECT_TRUE(
    messages->Messages.size() == 1 && messages->Messages[0].find("scalars of points") != std::string::npos)
    << "one message that names what colors come from, found " << messages->Messages.size();
}

/// Lines that reach beyond the surface have the color of the nearest point of it that is seen.
TEST(SplattingLinesStyle, ScalarsBeyondTheSurface)
{
  constexpr int size = 400;
  auto points = Torus();
  vtkNew<vtkFloatArray> sector;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const double* p = points->GetPoint(i);
    const double turn = 0.5 + 0.5 * std::atan2(p[1], p[0]) / vtkMath::Pi();
    sector->InsertNextValue(static_cast<float>(static_cast<int>(40.0 * turn) % 2));
  }
  points->GetPointData()->SetScalars(sector);
  SplattingLinesScene scene(points, size, size);
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(2);
  table->SetTableValue(0, 0.0, 1.0, 0.0);
  table->SetTableValue(1, 0.0, 0.0, 1.0);
  scene.Mapper->SetLookupTable(table);
  scene.Mapper->SetScalarRange(0.0, 1.0);
  scene.Mapper->SetInkColorMode(vtkInkSplattingLinesMapper::SCALARS);
  // All of the surface is ink.
  scene.Mapper->SetTau(1.2);
  scene.Mapper->SetPhi(500.0);
  const InkTestImage surface(scene.Window);
  scene.Mapper->SetLineWidth(20.0);
  const InkTestImage wide(scene.Window);
  /// 0 for paper, 1 and 2 for the colors.
  const auto colorAt = [](const InkTestImage& image, int x, int y) {
    return image.Channel(x, y, 0) > 127 ? 0 : image.Channel(x, y, 1) > image.Channel(x, y, 2) ? 1 : 2;
  };
  constexpr int reach = 8;
  int beyond = 0;
  int others = 0;
  for (int y = reach; y < size - reach; ++y)
  {
    for (int x = reach; x < size - reach; ++x)
    {
      if (colorAt(surface, x, y) != 0 || colorAt(wide, x, y) == 0)
      {
        continue;
      }
      int nearest[3] = { 0, size * size, size * size };
      for (int dy = -reach; dy <= reach; ++dy)
      {
        for (int dx = -reach; dx <= reach; ++dx)
        {
          int& best = nearest[colorAt(surface, x + dx, y + dy)];
          best = std::min(best, dx * dx + dy * dy);
        }
      }
      ++beyond;
      others += nearest[1] != nearest[2] && (nearest[1] < nearest[2]) != (colorAt(wide, x, y) == 1);
    }
  }
  EXPECT_GT(beyond, 3000);
  // Pixels that the surface covers by less than half, here paper, have its color, too.
  EXPECT_LE(others, beyond / 120) << "of " << beyond;
}

TEST(SplattingLinesStyle, Tone)
{
  // A dent's lines lie where the surface faces the viewer, the contour's where it does not.
  SplattingLinesScene scene(Torus());
  const InkTestImage black(scene.Window);
  scene.Mapper->SetInkColorMode(vtkInkSplattingLinesMapper::TONE);
  scene.Mapper->SetInkColor(0.0, 0.0, 0.0);
  scene.Mapper->SetToneColor(1.0, 0.0, 0.0);
  const InkTestImage toned(scene.Window);
  int redder = 0;
  int greener = 0;
  for (int y = 0; y < 200; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      redder += toned.Channel(x, y, 0) > black.Channel(x, y, 0) + 20;
      greener += std::abs(toned.Channel(x, y, 1) - black.Channel(x, y, 1)) > 1;
    }
  }
  EXPECT_TRUE(redder > 50 && greener == 0)
    << "some red in the lines, and nothing else: " << redder << ", " << greener;
}

/// The same ink on any paper.
TEST(SplattingLinesStyle, Papers)
{
  SplattingLinesScene scene(Torus());
  const InkTestImage onWhite(scene.Window);
  scene.Mapper->SetInkColor(1.0, 1.0, 1.0);
  scene.Mapper->SetPaperColor(0.0, 0.0, 0.0);
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  const InkTestImage onBlack(scene.Window);
  int different = 0;
  for (int y = 0; y < 200; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      different += std::abs(onWhite.Gray(x, y) + onBlack.Gray(x, y) - 255) > 1;
    }
  }
  EXPECT_EQ(different, 0) << "white on black is the negative; " << different << " pixels are not";
  scene.Mapper->SetInkColor(0.0, 0.0, 0.0);
  scene.Mapper->PaperVisibilityOff();
  scene.Renderer->SetBackground(1.0, 1.0, 1.0);
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(onWhite, 3), 0)
    << "ink alone on a white background is the same";
}

/// Around lines that are wider than the surface there is no paper.
TEST(SplattingLinesStyle, NoHalo)
{
  SplattingLinesScene scene(Torus());
  scene.Renderer->SetBackground(0.5, 0.5, 0.5);
  scene.Mapper->SetLineWidth(0.0);
  const InkTestImage plain(scene.Window);
  scene.Mapper->SetLineWidth(20.0);
  const InkTestImage wide(scene.Window);
  int lighter = 0;
  for (int y = 0; y < 200; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      lighter += wide.Gray(x, y) > plain.Gray(x, y) + 2;
    }
  }
  EXPECT_EQ(lighter, 0) << "nothing lighter for wider lines, found " << lighter << " pixels";
}

/// Only what is asked for: no splat is drawn again for a style, nothing is sent to the GPU.
TEST(SplattingLinesStyle, Uploads)
{
  SplattingLinesScene scene(Torus());
  scene.Window->Render();
  const vtkMTimeType time = scene.Mapper->GetUploadTime();
  scene.Mapper->SetHardness(0.5);
  scene.Mapper->SetLineWidth(3.0);
  scene.Mapper->HiddenLayersOn();
  scene.Mapper->SetInkColorMode(vtkInkSplattingLinesMapper::TONE);
  scene.Mapper->SetPointFraction(0.5);
  scene.Window->Render();
  EXPECT_EQ(scene.Mapper->GetUploadTime(), time) << "no upload for styles, layers and a part of the points";
}
