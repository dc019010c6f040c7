// SPDX-License-Identifier: BSD-3-Clause
// Strokes among other things: before and behind surfaces, clipped, in windows of all kinds, selected, far
// from the origin, colored.
#include "InkTestImage.h"
#include "InkTestViewports.h"
#include "StrokeScene.h"

#include "vtkActor2D.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkLookupTable.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

/// A surface cuts a stroke where it goes through it, and not where the stroke lies on it, slanted or not.
TEST(StrokeScene, Surfaces)
{
  for (const double slope : { 0.0, 1.0, 5.0 })
  {
    StrokeScene scene(MakeStrokes({ { { 20.0, 100.0, -80.0 * slope }, { 180.0, 100.0, 80.0 * slope } } }));
    scene.LookAtPixels();
    scene.Mapper->SetLineWidth(4.0);
    scene.Mapper->SetCapToButt();
    const double free = InkTestImage(scene.Window).Ink();
    vtkNew<vtkActor> actor;
    AddSurface(scene, actor, -100.0 * slope, 100.0 * slope);
    const InkTestImage on(scene.Window);
    EXPECT_EQ(on.CountDark(), 4 * 160) << "all of it on a surface with slope " << slope;
    EXPECT_NEAR(free, 4.0 * 160.0, 1.0);
  }
  StrokeScene scene(MakeStrokes({ { { 20.0, 100.0, -80.0 }, { 180.0, 100.0, 80.0 } } }));
  scene.LookAtPixels();
  scene.Mapper->SetLineWidth(4.0);
  scene.Mapper->SetLift(0.0);
  vtkNew<vtkActor> actor;
  AddSurface(scene, actor, 0.0, 0.0);
  const InkTestImage through(scene.Window);
  EXPECT_TRUE(through.CountDark(0, 0, 98, 200) == 0 && through.CountDark(102, 0, 200, 200) > 4 * 75)
    << "the half in front of the surface";
  EXPECT_NEAR(through.CountDark(), 4 * 80, 14);
}

TEST(StrokeScene, ClippingPlanes)
{
  StrokeScene scene(MakeStrokes({ HorizontalLine(100.0) }));
  scene.LookAtPixels();
  scene.Mapper->SetLineWidth(4.0);
  vtkNew<vtkPlane> right;
  right->SetOrigin(70.0, 0.0, 0.0);
  right->SetNormal(1.0, 0.0, 0.0);
  scene.Mapper->AddClippingPlane(right);
  const InkTestImage image(scene.Window);
  EXPECT_TRUE(image.CountDark(0, 0, 69, 200) == 0 && image.CountDark(71, 0, 200, 200) > 4 * 109)
    << "right of a plane";
  vtkNew<vtkPlane> left;
  left->SetOrigin(130.0, 0.0, 0.0);
  left->SetNormal(-1.0, 0.0, 0.0);
  scene.Mapper->AddClippingPlane(left);
  EXPECT_EQ(InkTestImage(scene.Window).CountDark(), 4 * 60) << "between two, each of which cuts an end off";
}

/// A polygon far larger than the picture, 50 in front of a line, and slanted planes that cut both: of the
/// line, what lies from 30 to 170; of the polygon, what lies from 80 to 120.
TEST(StrokeScene, ClippingPlanesCutLargePolygonsWhereTheyAre)
{
  StrokeScene scene(MakeStrokes({ HorizontalLine(100.0) }));
  scene.LookAtPixels();
  scene.Mapper->SetLineWidth(4.0);
  vtkNew<vtkPlaneSource> polygon;
  polygon->SetOrigin(-2000.0, -3000.0, 50.0);
  polygon->SetPoint1(5000.0, -3000.0, 50.0);
  polygon->SetPoint2(-2000.0, 3000.0, 50.0);
  polygon->Update();
  scene.Mapper->SetSurfaceData(polygon->GetOutput());
  EXPECT_EQ(InkTestImage(scene.Window).CountDark(), 0) << "hidden";
  for (const auto& [origin, side] : { std::pair(30.0, 1.0), std::pair(170.0, -1.0) })
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(origin, 0.0, 0.0);
    plane->SetNormal(side, 0.0, -1.0);
    scene.Mapper->AddClippingPlane(plane);
  }
  const InkTestImage image(scene.Window);
  EXPECT_EQ(image.CountDark(0, 0, 29, 200) + image.CountDark(171, 0, 200, 200), 0) << "cut off";
  EXPECT_EQ(image.CountDark(82, 0, 118, 200), 0) << "behind what is left of the polygon";
  EXPECT_NEAR(image.CountDark(30, 0, 80, 200), 4 * 50, 8);
  EXPECT_NEAR(image.CountDark(120, 0, 170, 200), 4 * 50, 8);
}

/// Of a stroke that runs through the nearest or the farthest distance that the camera shows, what lies
/// between.
TEST(StrokeScene, ClippingRange)
{
  for (const double middle : { 999.0, -1000.0 })
  {
    const double towards = middle > 0.0 ? 500.0 : -500.0;
    StrokeScene scene(
      MakeStrokes({ { { 20.0, 100.0, middle - towards }, { 180.0, 100.0, middle + towards } } }));
    scene.LookAtPixels();
    scene.Mapper->SetLineWidth(4.0);
    scene.Mapper->SetCapToButt();
    const InkTestImage image(scene.Window);
    EXPECT_NEAR(image.CountDark(0, 0, 100, 200), 4 * 80, 4) << middle;
    EXPECT_EQ(image.CountDark(101, 0, 200, 200, 255), 0) << middle;
  }
}

/// A picture in tiles is the large picture, and one in a viewport that of a window of its size.
TEST(StrokeScene, TilesAndViewports)
{
  const auto strokes = MakeStrokes({ Spiral() });
  for (const bool pixels : { false, true })
  {
    StrokeScene large(strokes, 400, 400);
    StrokeScene tiled(strokes, 200, 200);
    for (StrokeScene* scene : { &large, &tiled })
    {
      scene->Mapper->SetSizeUnit(pixels ? vtkInkStrokeMapper::PIXELS : vtkInkStrokeMapper::THOUSANDTHS);
      scene->Mapper->SetLineWidth(pixels ? 3.0 : 15.0);
      scene->Mapper->DashedOn();
      scene->Mapper->SetDashLength(pixels ? 8.0 : 40.0);
      scene->Mapper->SetGapLength(pixels ? 4.0 : 20.0);
      scene->Mapper->SetTaper(0.3);
    }
    if (pixels)
    {
      // Pixels are those of the window that is shown in tiles.
      large.Mapper->SetLineWidth(6.0);
      large.Mapper->SetDashLength(16.0);
      large.Mapper->SetGapLength(8.0);
    }
    const InkTestImage expected(large.Window);
    const InkTestImage tiles(tiled.Window, 2);
    EXPECT_EQ(tiles.CountDifferent(expected, 6), 0) << "in " << tiled.Mapper->GetSizeUnitAsString();
    EXPECT_GT(expected.CountDark(), 3000);
  }

  StrokeScene alone(strokes, 100, 200);
  const InkTestImage expected(alone.Window);
  StrokeScene both(strokes);
  EXPECT_EQ(CountDifferentInViewports(expected, both, both.Actor, 2), 0) << "two viewports like one";
}

/// Strokes, shifted and scaled together with the camera, are the same, also when the camera is among them.
TEST(StrokeScene, ScaleAndShift)
{
  for (const bool inside : { false, true })
  {
    StrokeScene reference(MakeStrokes({ Spiral() }));
    vtkCamera* from = reference.Renderer->GetActiveCamera();
    if (inside)
    {
      from->SetPosition(20.0, 5.0, -10.0);
      from->SetFocalPoint(100.0, 40.0, 20.0);
      from->SetViewAngle(100.0);
      from->SetClippingRange(1.0, 400.0);
    }
    const InkTestImage expected(reference.Window);
    EXPECT_GT(expected.CountDark(), 100);
    for (const auto& [scale, shift] :
      { std::pair{ 1.0, 1e7 }, std::pair{ 1e-9, 0.0 }, std::pair{ 1e9, 1e9 } })
    {
      StrokeScene scene(MakeStrokes({ Spiral(scale, shift) }));
      vtkCamera* camera = scene.Renderer->GetActiveCamera();
      double position[2][3];
      for (int axis = 0; axis < 3; ++axis)
      {
        position[0][axis] = scale * from->GetPosition()[axis] + shift;
        position[1][axis] = scale * from->GetFocalPoint()[axis] + shift;
      }
      camera->SetViewAngle(from->GetViewAngle());
      camera->SetPosition(position[0]);
      camera->SetFocalPoint(position[1]);
      camera->SetClippingRange(scale * from->GetClippingRange()[0], scale * from->GetClippingRange()[1]);
      const int different = InkTestImage(scene.Window).CountDifferent(expected, 30);
      EXPECT_LT(different, 12) << "scale " << scale << ", shift " << shift << ", inside " << inside;
    }
  }
}

TEST(StrokeScene, Selection)
{
  StrokeScene scene(MakeStrokes({ HorizontalLine(60.0), HorizontalLine(140.0) }));
  scene.LookAtPixels();
  scene.Mapper->SetLineWidth(1.0);
  const InkTestImage before(scene.Window);
  const auto select = [&](int x0, int y0, int x1, int y1)
  {
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(scene.Renderer);
    selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
    selector->SetArea(static_cast<unsigned int>(x0), static_cast<unsigned int>(y0),
      static_cast<unsigned int>(x1), static_cast<unsigned int>(y1));
    const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
    std::set<vtkIdType> found;
    for (unsigned int node = 0; node < selection->GetNumberOfNodes(); ++node)
    {
      auto* ids = vtkIdTypeArray::SafeDownCast(selection->GetNode(node)->GetSelectionList());
      found.insert(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfTuples());
    }
    return found;
  };
  EXPECT_EQ(select(0, 0, 199, 199), (std::set<vtkIdType>{ 0, 1, 2, 3, 4, 5 })) << "all points";
  EXPECT_EQ(select(70, 50, 110, 70), (std::set<vtkIdType>{ 1 })) << "the nearer point of a segment";
  EXPECT_EQ(select(150, 130, 190, 150), (std::set<vtkIdType>{ 5 }));
  EXPECT_TRUE(select(0, 80, 199, 120).empty()) << "nothing between the strokes";
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(before), 0) << "the same picture afterwards";
}

/// Width by the distance, by an array, in the world's unit.
TEST(StrokeScene, Widths)
{
  const auto strokes = MakeStrokes({ HorizontalLine(60.0, 100.0), HorizontalLine(140.0, -100.0) });
  StrokeScene scene(strokes);
  scene.LookAtPixels();
  scene.Mapper->SetCapToButt();
  scene.Mapper->SetLineWidth(8.0);
  const auto ink = [&](int y)
  {
    const InkTestImage image(scene.Window);
    double sum = 0.0;
    for (int row = y - 20; row < y + 20; ++row)
    {
      sum += 1.0 - image.Gray(100, row) / 255.0;
    }
    return sum;
  };
  EXPECT_NEAR(ink(60), 8.0, 0.05);
  scene.Mapper->SetDepthWidth(0.75);
  EXPECT_NEAR(ink(60), 8.0, 0.05) << "the nearest";
  EXPECT_NEAR(ink(140), 2.0, 0.05) << "the farthest";
  scene.Mapper->SetDepthWidth(0.0);

  strokes->GetPointData()->AddArray(Values("Width", { 1.0f, 1.0f, 1.0f, 0.0f, 0.5f, NAN }));
  EXPECT_NEAR(ink(60), 8.0, 0.05);
  EXPECT_NEAR(ink(140), 4.0, 0.1) << "by the array";
  strokes->GetPointData()->AddArray(Values("Own", { 2.0f, 2.0f, 2.0f, 1.0f, 1.0f, 1.0f }));
  scene.Mapper->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Own");
  EXPECT_NEAR(ink(60), 16.0, 0.05) << "by another array";

  scene.Mapper->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "None");
  scene.Mapper->SetSizeUnitToWorld();
  scene.Mapper->SetLineWidth(5.0);
  EXPECT_NEAR(ink(60), 5.0, 0.05) << "5 units of a pixel";
  scene.Renderer->GetActiveCamera()->ParallelProjectionOff();
  scene.Renderer->GetActiveCamera()->SetViewAngle(2.0 * std::atan(0.1) * 180.0 / std::numbers::pi);
  EXPECT_NEAR(ink(56), 5.0 * 1000.0 / 900.0, 0.05) << "nearer";
  EXPECT_NEAR(ink(136), 5.0 * 1000.0 / 1100.0, 0.05) << "farther";
}

/// What lies at one depth but for rounding is not spread over all widths.
TEST(StrokeScene, EquallyFarStrokesAreEquallyWide)
{
  StrokeScene scene(MakeStrokes({ HorizontalLine(60.0, 1e-3), HorizontalLine(140.0, -1e-3) }));
  scene.LookAtPixels();
  scene.Mapper->SetCapToButt();
  scene.Mapper->SetLineWidth(8.0);
  scene.Mapper->SetDepthWidth(0.75);
  const InkTestImage image(scene.Window);
  for (const int y : { 60, 140 })
  {
    double ink = 0.0;
    for (int row = y - 20; row < y + 20; ++row)
    {
      ink += 1.0 - image.Gray(100, row) / 255.0;
    }
    EXPECT_NEAR(ink, 8.0, 0.05) << y;
  }
}

/// Strokes are only dropped as the density falls.
TEST(StrokeScene, Density)
{
  std::vector<StrokePolyline> lines;
  std::vector<float> priorities;
  for (int i = 0; i < 18; ++i)
  {
    lines.push_back(HorizontalLine(10.0 * i + 10.5));
    priorities.push_back(static_cast<float>((i * 7) % 18) / 18.0f);
  }
  const auto strokes = MakeStrokes(lines);
  for (const bool ordered : { false, true })
  {
    if (ordered)
    {
      strokes->GetCellData()->AddArray(Values("Priority", priorities));
    }
    StrokeScene scene(strokes);
    scene.LookAtPixels();
    scene.Mapper->SetLineWidth(2.0);
    std::set<int> before;
    for (int i = 0; i < 18; ++i)
    {
      before.insert(i);
    }
    for (const double density : { 1.0, 0.75, 0.5, 0.2, 0.0 })
    {
      scene.Mapper->SetDensity(density);
      const InkTestImage image(scene.Window);
      std::set<int> drawn;
      for (int i = 0; i < 18; ++i)
      {
        if (image.IsDark(100, 10 * i + 10))
        {
          drawn.insert(i);
          EXPECT_TRUE(before.count(i)) << "only dropped";
          EXPECT_TRUE(!ordered || priorities[static_cast<std::size_t>(i)] < density) << i;
        }
      }
      const double expected = density * 18.0;
      EXPECT_NEAR(static_cast<double>(drawn.size()), expected, ordered ? 1.0 : 7.0) << "density " << density;
      before = drawn;
    }
    EXPECT_TRUE(before.empty());
  }
}
