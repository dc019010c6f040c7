// SPDX-License-Identifier: BSD-3-Clause
// From where a picture is taken: named sides, axes that are up, what is chosen for meshes.
#include "StyleErrors.h"

#include "vtkAppendPolyData.h"
#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkImageData.h"
#include "vtkInkView.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace
{

using Vector = std::array<double, 3>;

void ExpectNear(const Vector& found, const Vector& expected, const std::string& what)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(found[i], expected[i], 1e-12) << what << ' ' << i;
  }
}

/// Where a view looks, and what is up then.
std::array<Vector, 2> Look(vtkInkView* view, double turned = 0.0)
{
  vtkNew<vtkCamera> camera;
  view->Apply(camera, turned);
  std::array<Vector, 2> look;
  camera->GetDirectionOfProjection(look[0].data());
  camera->GetViewUp(look[1].data());
  return look;
}

vtkSmartPointer<vtkPolyData> Boxes(const std::vector<std::array<double, 6>>& bounds)
{
  vtkNew<vtkAppendPolyData> all;
  for (const std::array<double, 6>& b : bounds)
  {
    vtkNew<vtkCubeSource> box;
    box->SetBounds(b.data());
    all->AddInputConnection(box->GetOutputPort());
  }
  all->Update();
  return all->GetOutput();
}

/// A slab on a foot, twice as wide along x as along the other side, with an axis up.
vtkSmartPointer<vtkPolyData> Table(bool yIsUp)
{
  vtkNew<vtkAppendPolyData> both;
  for (const bool isFoot : { false, true })
  {
    const double depth = isFoot ? 1.5 : 2.0;
    const double height = isFoot ? 2.0 : 0.5;
    const double middle = isFoot ? 1.0 : 2.25;
    vtkNew<vtkCubeSource> box;
    box->SetXLength(isFoot ? 3.0 : 4.0);
    box->SetYLength(yIsUp ? height : depth);
    box->SetZLength(yIsUp ? depth : height);
    box->SetCenter(0.0, yIsUp ? middle : 0.0, yIsUp ? 0.0 : middle);
    both->AddInputConnection(box->GetOutputPort());
  }
  both->Update();
  return both->GetOutput();
}

} // namespace

TEST(View, SidesAreTheSubjects)
{
  const double third = 1.0 / std::sqrt(3.0);
  const double sixth = 1.0 / std::sqrt(6.0);
  const struct
  {
    const char* name;
    Vector direction;
    Vector up;
  } sides[] = { { "front", { 0, 1, 0 }, { 0, 0, 1 } }, { "back", { 0, -1, 0 }, { 0, 0, 1 } },
    { "left", { -1, 0, 0 }, { 0, 0, 1 } }, { "right", { 1, 0, 0 }, { 0, 0, 1 } },
    { "top", { 0, 0, -1 }, { 0, 1, 0 } }, { "bottom", { 0, 0, 1 }, { 0, -1, 0 } },
    { "iso", { -third, third, -third }, { -sixth, sixth, 2 * sixth } } };
  ASSERT_EQ(vtkInkView::GetNumberOfNames(), 7);
  for (int i = 0; i < 7; ++i)
  {
    vtkNew<vtkInkView> view;
    EXPECT_STREQ(vtkInkView::GetNameOfView(i), sides[i].name);
    view->SetName(sides[i].name);
    const auto [direction, up] = Look(view);
    ExpectNear(direction, sides[i].direction, sides[i].name);
    ExpectNear(up, sides[i].up, sides[i].name);
  }
  EXPECT_EQ(vtkInkView::GetNameOfView(7), nullptr);
}

TEST(View, AnotherAxisIsTheTop)
{
  const struct
  {
    const char* axis;
    Vector front;
    Vector up;
  } tops[] = { { "x", { 0, 0, 1 }, { 1, 0, 0 } }, { "y", { 0, 0, -1 }, { 0, 1, 0 } },
    { "z", { 0, 1, 0 }, { 0, 0, 1 } }, { "-x", { 0, 0, 1 }, { -1, 0, 0 } },
    { "-y", { 0, 0, 1 }, { 0, -1, 0 } }, { "-z", { 0, 1, 0 }, { 0, 0, -1 } } };
  ASSERT_EQ(vtkInkView::GetNumberOfAxes(), 6);
  for (int i = 0; i < 6; ++i)
  {
    vtkNew<vtkInkView> view;
    EXPECT_STREQ(vtkInkView::GetAxis(i), tops[i].axis);
    view->SetUp(tops[i].axis);
    const auto [direction, up] = Look(view);
    ExpectNear(direction, tops[i].front, tops[i].axis);
    ExpectNear(up, tops[i].up, tops[i].axis);
  }
}

TEST(View, TheViewerGoesAround)
{
  const double half = std::sqrt(0.5);
  vtkNew<vtkInkView> view;
  view->SetAzimuth(45.0);
  // To the right of one who looks along y is x.
  ExpectNear(Look(view)[0], { -half, half, 0 }, "azimuth");
  ExpectNear(Look(view, 45.0)[0], { -1, 0, 0 }, "turned");
  view->SetAzimuth(0.0);
  view->SetElevation(45.0);
  ExpectNear(Look(view)[0], { 0, half, -half }, "elevation");
  ExpectNear(Look(view)[1], { 0, half, half }, "up");
  ExpectNear(Look(view, 90.0)[0], { -half, 0, -half }, "turned around what is upright");
}

TEST(View, MeshesStandAndShowMost)
{
  for (const bool yIsUp : { false, true })
  {
    vtkNew<vtkInkView> view;
    view->Choose(Table(yIsUp));
    EXPECT_EQ(view->GetUp(), yIsUp ? "y" : "z");
    EXPECT_EQ(view->GetName(), "front");
    // What is said stays, and is what the rest is chosen for.
    vtkNew<vtkInkView> said;
    said->SetUp("x");
    said->Choose(Table(yIsUp));
    EXPECT_EQ(said->GetUp(), "x");
  }
  // Alike along both axes: the file's name decides.
  vtkNew<vtkCubeSource> cube;
  cube->Update();
  for (const auto& [file, up] : { std::pair("a.ply", "z"), std::pair("a.OBJ", "y") })
  {
    vtkNew<vtkInkView> view;
    view->Choose(cube->GetOutput(), file);
    EXPECT_EQ(view->GetUp(), up) << file;
  }
  // Deep along y, so its side is what shows.
  vtkNew<vtkCubeSource> deep;
  deep->SetYLength(3.0);
  deep->Update();
  vtkNew<vtkInkView> view;
  view->SetUp("z");
  view->Choose(deep->GetOutput());
  EXPECT_EQ(view->GetName(), "left");
}

TEST(View, WhatIsLongDoesNotStandOnItsEnd)
{
  // A body with a flat end on four short legs: the end is more of its height's shadow than the feet are of
  // the body's.
  const auto animal = Boxes({ { -0.5, 0.5, 0, 4, 0.5, 1.5 }, { -0.5, -0.3, 0.8, 1.0, 0, 0.5 },
    { 0.3, 0.5, 0.8, 1.0, 0, 0.5 }, { -0.5, -0.3, 2.4, 2.6, 0, 0.5 }, { 0.3, 0.5, 2.4, 2.6, 0, 0.5 } });
  vtkNew<vtkInkView> view;
  view->Choose(animal, "pig.stl");
  EXPECT_EQ(view->GetUp(), "z");
  EXPECT_EQ(view->GetName(), "left");
  // Without such feet it is as tall as it is long, as a bear on its back.
  view->Choose(Boxes({ { -0.5, 0.5, 0, 4, 0.5, 1.5 }, { -0.1, 0.1, 1, 1.5, 0, 0.5 } }), "bear.ply");
  EXPECT_EQ(view->GetUp(), "y");
  // Nor does a wall lie on its side.
  view->Choose(Boxes({ { 0, 4, 0, 0.2, 0, 3 } }), "wall.stl");
  EXPECT_EQ(view->GetUp(), "z");
  EXPECT_EQ(view->GetElevation(), 20.0) << "not as what lies flat, but as one flat face";
}

TEST(View, WhatLiesFlatIsSeenFromAbove)
{
  vtkNew<vtkCubeSource> flat;
  flat->SetXLength(4.0);
  flat->SetYLength(3.0);
  flat->SetZLength(0.2);
  flat->Update();
  vtkNew<vtkInkView> view;
  view->Choose(flat->GetOutput());
  EXPECT_EQ(view->GetElevation(), 30.0);
  vtkNew<vtkInkView> named;
  named->SetName("front");
  named->Choose(flat->GetOutput());
  EXPECT_EQ(named->GetElevation(), 0.0);
  vtkNew<vtkInkView> low;
  low->SetElevation(5.0);
  low->Choose(flat->GetOutput());
  EXPECT_EQ(low->GetElevation(), 5.0);
  // And images as they are.
  vtkNew<vtkImageData> image;
  image->SetDimensions(40, 30, 2);
  view->Choose(image);
  EXPECT_EQ(view->GetName() + view->GetUp(), "frontz");
  EXPECT_EQ(view->GetElevation(), 0.0);
}

TEST(View, WhatIsHiddenDoesNotCount)
{
  // Boards behind each other, which fill a row of 1 x 2 from the front and of 2.2 x 2 from the left.
  std::vector<std::array<double, 6>> boards;
  for (int i = 0; i < 8; ++i)
  {
    boards.push_back({ 0.0, 1.0, 0.3 * i, 0.3 * i + 0.1, 0.0, 2.0 });
  }
  boards.push_back({ 0.4, 0.6, 0.0, 2.2, 0.0, 2.0 });
  vtkNew<vtkInkView> view;
  view->SetUp("z");
  view->Choose(Boxes(boards));
  EXPECT_EQ(view->GetName(), "left");
  // Nor does it matter which way round polygons run, as of a pipe that is inside out.
  for (const bool isInsideOut : { false, true })
  {
    vtkNew<vtkCylinderSource> pipe;
    pipe->SetHeight(4.0);
    pipe->SetResolution(20);
    pipe->CappingOff();
    vtkNew<vtkReverseSense> reversed;
    reversed->SetInputConnection(pipe->GetOutputPort());
    reversed->Update();
    view->SetUp("z");
    view->Choose(isInsideOut ? reversed->GetOutput() : pipe->GetOutput());
    EXPECT_EQ(view->GetName(), "left") << isInsideOut << ": not through it";
  }
}

TEST(View, OneFlatFaceIsSeenAtAnAngle)
{
  const auto plate = Boxes({ { 0, 4, 0, 1, 0, 3 } });
  vtkNew<vtkInkView> view;
  view->Choose(plate, "plate.stl");
  EXPECT_EQ(view->GetName(), "front");
  EXPECT_EQ(view->GetAzimuth(), 30.0);
  EXPECT_EQ(view->GetElevation(), 20.0);
  // Of several faces the front shows more than one.
  view->Choose(Boxes({ { 0, 4, 0, 1, 0, 3 }, { 0, 4, -2, 0, 0, 0.2 }, { 1, 3, -1, 0, 0, 3 } }), "parts.stl");
  EXPECT_EQ(view->GetAzimuth(), 30.0) << "parallel to each other";
  vtkNew<vtkInkView> straight;
  straight->SetAzimuth(0.0);
  straight->SetElevation(0.0);
  straight->Choose(plate, "plate.stl");
  EXPECT_EQ(straight->GetAzimuth(), 0.0);
  EXPECT_EQ(straight->GetElevation(), 0.0);
  vtkNew<vtkInkView> named;
  named->SetName("front");
  named->Choose(plate, "plate.stl");
  EXPECT_EQ(named->GetAzimuth(), 0.0);
  vtkNew<vtkSphereSource> ball;
  ball->Update();
  view->Choose(ball->GetOutput());
  EXPECT_EQ(view->GetAzimuth(), 0.0);
}

TEST(View, MapsHaveTheirHeightUp)
{
  // A steep strip of land, taller than it is wide: of a survey, and of a scan around the origin.
  for (const bool isMap : { true, false })
  {
    vtkNew<vtkPoints> points;
    for (int i = 0; i < 3000; ++i)
    {
      const double x = 50.0 * std::fmod(0.618034 * i, 1.0);
      const double y = 0.1 * i;
      points->InsertNextPoint(x + (isMap ? 512700.0 : 0.0), y + (isMap ? 5403550.0 : 0.0), 2.0 * x);
    }
    vtkNew<vtkPolyData> cloud;
    cloud->SetPoints(points);
    vtkNew<vtkInkView> view;
    view->Choose(cloud, "land.obj");
    EXPECT_EQ(view->GetUp(), isMap ? "z" : "y");
    EXPECT_EQ(view->GetElevation(), isMap ? 30.0 : 0.0);
    vtkNew<vtkInkView> said;
    said->SetUp("y");
    said->Choose(cloud, "land.obj");
    EXPECT_EQ(said->GetUp(), "y");
    EXPECT_EQ(said->GetElevation(), 0.0);
  }
}

TEST(View, VolumesAreSeenFromWhereTheyShowClearlyMore)
{
  const struct
  {
    Vector size;
    const char* up;
    const char* name;
  } boxes[] = { { { 2, 2, 2 }, "z", "front" }, { { 5, 5, 3.2 }, "z", "front" }, { { 5, 5, 3.1 }, "z", "top" },
    { { 2, 3.3, 9 }, "z", "left" }, { { 2, 3.1, 9 }, "z", "front" }, { { 9, 2, 9 }, "z", "front" },
    { { 1, 9, 1 }, "z", "left" }, { { 1, 9, 0.9 }, "z", "left" }, { { 2, 9, 1 }, "z", "top" },
    // With y up, the depth is along z.
    { { 5, 2, 5 }, "y", "top" }, { { 5, 5, 2 }, "y", "front" }, { { 0, 0, 0 }, "z", "front" } };
  for (const auto& box : boxes)
  {
    vtkNew<vtkPoints> frame;
    frame->InsertNextPoint(-1.0, 7.0, 3.0);
    frame->InsertNextPoint(-1.0 + box.size[0], 7.0 + box.size[1], 3.0 + box.size[2]);
    vtkNew<vtkImageData> image;
    vtkNew<vtkInkView> view;
    view->SetUp(box.up);
    view->Choose(image);
    view->ChooseForFrame(frame);
    EXPECT_EQ(view->GetName(), box.name)
      << box.size[0] << ' ' << box.size[1] << ' ' << box.size[2] << ' ' << box.up;
    // What is said stays.
    vtkNew<vtkInkView> said;
    said->SetName("back");
    said->ChooseForFrame(frame);
    EXPECT_EQ(said->GetName(), "back");
  }
}

TEST(View, SlabsThatTheirImageCutsAreSeenAtAnAngle)
{
  const struct
  {
    int dimensions[3];
    double gap; ///< between what is drawn and both ends, voxels
    const char* name;
    double azimuth, elevation;
    const char* seenThrough;
  } slabs[] = { { { 11, 11, 3 }, 0.2, "front", 0.0, 45.0, "top" },
    { { 11, 11, 3 }, 0.9, "top", 0.0, 0.0, "top" }, { { 3, 11, 11 }, 0.2, "left", 45.0, 0.0, "left" },
    { { 11, 11, 9 }, 0.0, "front", 0.0, 0.0, "front" }, { { 11, 11, 8 }, 0.0, "front", 0.0, 0.0, "top" },
    { { 11, 11, 8 }, 0.9, "top", 0.0, 0.0, "top" } };
  for (const auto& slab : slabs)
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(slab.dimensions);
    image->SetOrigin(3.0, -7.0, 1.0);
    // Scans are tilted.
    image->SetDirectionMatrix(0.96, -0.28, 0.0, 0.28, 0.96, 0.0, 0.0, 0.0, 1.0);
    vtkNew<vtkPoints> frame;
    const int thin =
      static_cast<int>(std::min_element(slab.dimensions, slab.dimensions + 3) - slab.dimensions);
    const auto add = [&](const double(&index)[3])
    {
      double point[3];
      image->TransformContinuousIndexToPhysicalPoint(index, point);
      frame->InsertNextPoint(point);
    };
    // The corners, and a quarter of both ends.
    for (const bool last : { false, true })
    {
      const auto at = [&](int axis, bool isLast)
      { return isLast ? slab.dimensions[axis] - 1 - slab.gap : slab.gap; };
      double index[3];
      index[thin] = at(thin, last);
      for (int corner = 0; corner < 4; ++corner)
      {
        index[(thin + 1) % 3] = at((thin + 1) % 3, corner % 2 == 1);
        index[(thin + 2) % 3] = at((thin + 2) % 3, corner / 2 == 1);
        add(index);
      }
      for (int n = 0; n < 25; ++n)
      {
        index[(thin + 1) % 3] = 2.5 + n % 5;
        index[(thin + 2) % 3] = 2.5 + n / 5;
        add(index);
      }
    }
    vtkNew<vtkInkView> view;
    view->Choose(image);
    view->ChooseForFrame(frame);
    EXPECT_EQ(view->GetName(), slab.name) << slab.gap;
    EXPECT_EQ(view->GetAzimuth(), slab.azimuth) << slab.name;
    EXPECT_EQ(view->GetElevation(), slab.elevation) << slab.name;
    // Through its flat sides.
    view->ChooseForFrame(frame, true);
    EXPECT_EQ(view->GetAzimuth(), 0.0);
    EXPECT_EQ(view->GetElevation(), 0.0);
    EXPECT_EQ(view->GetName(), slab.seenThrough) << slab.name;
    vtkNew<vtkInkView> said;
    said->SetElevation(20.0);
    said->SetAzimuth(10.0);
    said->Choose(image);
    said->ChooseForFrame(frame);
    EXPECT_EQ(said->GetElevation(), 20.0);
    EXPECT_EQ(said->GetAzimuth(), 10.0);
  }
}

TEST(View, BlocksAreSeenFromACorner)
{
  // The covered shares of the sides that the corner shows, top, front and left, of a scan on its side.
  const struct
  {
    std::array<double, 3> covered;
    const char* name;
  } blocks[] = { { { 1.0, 1.0, 1.0 }, "iso" }, { { 0.6, 0.6, 0.6 }, "iso" }, { { 0.3, 1.0, 1.0 }, "front" },
    { { 1.0, 0.3, 1.0 }, "front" }, { { 1.0, 1.0, 0.3 }, "front" } };
  for (const auto& block : blocks)
  {
    constexpr int size = 33;
    vtkNew<vtkImageData> image;
    image->SetExtent(-3, -3 + size - 1, 5, 5 + size - 1, 0, size - 1);
    image->SetSpacing(0.5, 0.5, 0.5);
    // The image's first axis runs to the top, its second to the front, its third to the left.
    image->SetDirectionMatrix(0.0, 0.0, 1.0, 0.0, -1.0, 0.0, 1.0, 0.0, 0.0);
    vtkNew<vtkPoints> frame;
    const auto add = [&](double top, double front, double left)
    {
      double point[3];
      const double index[3] = { -3.0 + top, 5.0 + front, left };
      image->TransformContinuousIndexToPhysicalPoint(index, point);
      frame->InsertNextPoint(point);
    };
    constexpr double last = size - 1;
    for (int i = 0; i < size; ++i)
    {
      for (int j = 0; j < size; ++j)
      {
        const double share = (j + 0.5) / size;
        share < block.covered[0] ? add(i, last - 0.4, j) : add(i, last - 1.6, j);
        share < block.covered[1] ? add(i, j, last - 0.4) : add(i, j, last - 1.6);
        share < block.covered[2] ? add(last - 0.4, i, j) : add(last - 1.6, i, j);
      }
    }
    vtkNew<vtkInkView> view;
    view->Choose(image);
    view->ChooseForFrame(frame);
    EXPECT_EQ(view->GetName(), block.name);
    // The opposite sides do not count.
    image->SetDirectionMatrix(0.0, 0.0, -1.0, 0.0, 1.0, 0.0, -1.0, 0.0, 0.0);
    vtkNew<vtkInkView> opposite;
    opposite->Choose(image);
    vtkNew<vtkPoints> turned;
    for (vtkIdType i = 0; i < frame->GetNumberOfPoints(); ++i)
    {
      double point[3];
      frame->GetPoint(i, point);
      turned->InsertNextPoint(-point[0], -point[1], -point[2]);
    }
    opposite->ChooseForFrame(turned);
    EXPECT_EQ(opposite->GetName(), "front");
    vtkNew<vtkInkView> said;
    said->SetAzimuth(10.0);
    said->Choose(image);
    said->ChooseForFrame(frame);
    EXPECT_EQ(said->GetName(), "front");
  }
}

/// Within an image that they do not touch.
TEST(View, BlocksOfTheirOwnAreSeenFromACorner)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 64, 64);
  image->SetDirectionMatrix(0.96, -0.28, 0.0, 0.28, 0.96, 0.0, 0.0, 0.0, 1.0);
  const auto nameOf = [&](double round, double azimuth)
  {
    vtkNew<vtkPoints> frame;
    constexpr int size = 33;
    for (int side = 0; side < 6; ++side)
    {
      for (int n = 0; n < size * size; ++n)
      {
        const double u = n % size;
        const double v = n / size;
        const double middle = (size - 1) / 2.0;
        const double bulge = round * (std::pow(u / middle - 1.0, 2.0) + std::pow(v / middle - 1.0, 2.0));
        double index[3];
        index[side / 2] = 15.3 + (side % 2 == 0 ? bulge : size - 1 - bulge);
        index[(side / 2 + 1) % 3] = 15.3 + u;
        index[(side / 2 + 2) % 3] = 15.3 + v;
        double point[3];
        image->TransformContinuousIndexToPhysicalPoint(index, point);
        frame->InsertNextPoint(point);
      }
    }
    vtkNew<vtkInkView> view;
    if (azimuth != 0.0)
    {
      view->SetAzimuth(azimuth);
    }
    view->Choose(image);
    view->ChooseForFrame(frame);
    return view->GetName();
  };
  EXPECT_EQ(nameOf(0.0, 0.0), "iso");
  EXPECT_EQ(nameOf(0.5, 0.0), "iso") << "its edges are round";
  EXPECT_EQ(nameOf(4.0, 0.0), "front") << "its sides are bent";
  EXPECT_EQ(nameOf(0.0, 10.0), "front") << "an angle was set";
}

TEST(View, FramesChangeNothingForMeshesAndWhereThereIsNone)
{
  vtkNew<vtkCubeSource> flat;
  flat->SetZLength(0.1);
  flat->Update();
  vtkNew<vtkInkView> view;
  view->Choose(flat->GetOutput());
  view->ChooseForFrame(flat->GetOutput()->GetPoints());
  EXPECT_EQ(view->GetName(), "front");
  vtkNew<vtkInkView> other;
  other->ChooseForFrame(nullptr);
  vtkNew<vtkPoints> none;
  other->ChooseForFrame(none);
  EXPECT_EQ(other->GetName(), "front");
  other->ChooseForFrame(flat->GetOutput()->GetPoints());
  EXPECT_EQ(other->GetName(), "top");
}

TEST(View, UnknownNamesAreRefused)
{
  vtkNew<vtkInkView> view;
  const StyleErrors errors(view);
  view->SetName("side");
  view->SetUp("w");
  ASSERT_EQ(errors.All.size(), 2u);
  EXPECT_NE(errors.All[0].find("expected one of front, back, left, right, top, bottom, iso, found 'side'"),
    std::string::npos)
    << errors.All[0];
  EXPECT_NE(
    errors.All[1].find("expected one of x, y, z, -x, -y, -z, found 'w'; it stays z"), std::string::npos);
  EXPECT_EQ(view->GetName() + view->GetUp(), "frontz");
}

TEST(View, SmallPicturesAreRenderedLarger)
{
  EXPECT_EQ(vtkInkView::GetSupersampling(1024, 768), 2);
  EXPECT_EQ(vtkInkView::GetSupersampling(500, 20), 2) << "however low";
  EXPECT_EQ(vtkInkView::GetSupersampling(499, 499), 2);
  EXPECT_EQ(vtkInkView::GetSupersampling(240, 200), 3);
  EXPECT_EQ(vtkInkView::GetSupersampling(64, 64), 4);
  // By the height, of which splats' sizes are parts.
  EXPECT_EQ(vtkInkView::GetSupersampling(400, 100), 4);
  EXPECT_EQ(vtkInkView::GetSupersampling(100, 400), 2);
}
