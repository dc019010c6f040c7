// SPDX-License-Identifier: BSD-3-Clause
// Stipples among other things: hidden by surfaces, clipped, in windows of all kinds, selected, far from the
// origin.
#include "InkTestImage.h"
#include "InkTestStipples.h"
#include "InkTestViewports.h"
#include "StippleScene.h"

#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkPlane.h"
#include "vtkPolyDataMapper.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

vtkSmartPointer<vtkPolyData> Voxels()
{
  return InkTestStipples::SphereVoxels(1.0, 0.08, 12);
}

vtkSmartPointer<vtkPolyData> SphereMesh(double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(120);
  sphere->SetPhiResolution(120);
  sphere->Update();
  return sphere->GetOutput();
}

} // namespace

/// The surface hides the far half of its own stipples and nothing of the near half.
TEST(StippleScene, Hidden)
{
  auto stipples = InkTestStipples::SphereSurface(1.0, 2000, 12);
  vtkNew<vtkFloatArray> marks;
  StippleScene scene(stipples, 300, 300);
  scene.AllOff();
  scene.Mapper->SetPixelsPerStipple(1.0);
  scene.Mapper->SetSurfaceData(SphereMesh(1.0));
  scene.Window->Render();
  ASSERT_TRUE(scene.Mapper->EvaluateMarks(scene.Renderer, scene.Actor, marks)) << "marks";
  const double eye = scene.Renderer->GetActiveCamera()->GetPosition()[2];
  int shownBehind = 0;
  int hiddenBefore = 0;
  int before = 0;
  for (vtkIdType i = 0; i < stipples->GetNumberOfPoints(); ++i)
  {
    double p[3];
    stipples->GetPoint(i, p);
    const bool drawn = marks->GetComponent(i, 1) > 0.0;
    // The outline as seen from the eye lies at z = 1 / eye.
    before += p[2] > 1.0 / eye + 0.05;
    hiddenBefore += p[2] > 1.0 / eye + 0.05 && !drawn;
    shownBehind += p[2] < 1.0 / eye - 0.15 && drawn;
  }
  EXPECT_TRUE(before > 5000 && hiddenBefore == 0)
    << "none of " << before << " stipples before, but " << hiddenBefore << " hidden";
  EXPECT_EQ(shownBehind, 0) << "none behind, but " << shownBehind << " shown";

  // Without a surface, those that face away are left out all the same.
  scene.Mapper->SetSurfaceData(nullptr);
  scene.Window->Render();
  scene.Mapper->EvaluateMarks(scene.Renderer, scene.Actor, marks);
  shownBehind = 0;
  for (vtkIdType i = 0; i < stipples->GetNumberOfPoints(); ++i)
  {
    shownBehind += stipples->GetPoint(i)[2] < 1.0 / eye - 0.15 && marks->GetComponent(i, 1) > 0.0;
  }
  EXPECT_EQ(shownBehind, 0) << "none that face away, but " << shownBehind;
}

/// A volume is see-through, unless an iso-surface hides what lies behind it.
TEST(StippleScene, OccludedVolume)
{
  StippleScene scene(Voxels());
  scene.AllOff();
  scene.Mapper->SetPixelsPerStipple(60.0);
  const double all = InkTestImage(scene.Window).Ink();
  scene.Mapper->SetSurfaceData(SphereMesh(1.0));
  const double front = InkTestImage(scene.Window).Ink();
  EXPECT_TRUE(front < 0.85 * all && front > 0.4 * all) << "the front only: " << front << " of " << all;
  const InkTestImage before(scene.Window);
  scene.Mapper->SetSurfaceData(SphereMesh(1e-3));
  EXPECT_LT(std::abs(InkTestImage(scene.Window).Ink() / all - 1.0), 0.01) << "all of it with a tiny surface";
  scene.Mapper->SetSurfaceData(SphereMesh(1.0));
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(before), 0) << "the hidden picture again";
}

/// Other actors hide stipples, and stipples do not touch other actors.
TEST(StippleScene, AmongActors)
{
  for (int kind : { 0, 1, 2 })
  {
    StippleScene scene(Voxels(), 300, 200);
    scene.AllOff();
    scene.Renderer->SetUseDepthPeeling(kind == 1);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(SphereMesh(0.9));
    vtkNew<vtkActor> other;
    other->SetMapper(mapper);
    other->SetPosition(1.0, 0.0, 1.5);
    other->GetProperty()->SetColor(1.0, 0.0, 0.0);
    other->GetProperty()->SetOpacity(kind == 0 ? 1.0 : 0.4);
    scene.Renderer->AddActor(other);
    scene.Renderer->ResetCamera();
    const InkTestImage with(scene.Window);
    scene.Actor->VisibilityOff();
    const InkTestImage without(scene.Window);
    EXPECT_GT(with.CountDifferent(without, 30), 300) << "stipples beside an actor, kind " << kind;
    // Away from the stipples' sphere, the actor looks as it did. It fills the middle of the right side.
    int different = 0;
    for (int y = 0; y < 200; ++y)
    {
      for (int x = 235; x < 300; ++x)
      {
        different += with.Channel(x, y, 1) != without.Channel(x, y, 1);
      }
    }
    EXPECT_EQ(different, 0) << "the actor as without stipples, kind " << kind << ": " << different;
    if (kind == 0)
    {
      int red = 0;
      int spoilt = 0;
      for (int y = 0; y < 200; ++y)
      {
        for (int x = 0; x < 300; ++x)
        {
          const bool actor = without.Channel(x, y, 0) > without.Channel(x, y, 1) + 60;
          red += actor;
          spoilt += actor && with.Gray(x, y) != without.Gray(x, y);
        }
      }
      EXPECT_TRUE(red > 2000 && spoilt == 0)
        << "no stipple on an actor in front, " << spoilt << " of " << red;
    }
  }
}

TEST(StippleScene, Windows)
{
  StippleScene scene(Voxels());
  const InkTestImage first(scene.Window);
  EXPECT_GT(first.CountDark(), 100) << "dark pixels, " << first.CountDark();
  const vtkMTimeType time = scene.Mapper->GetUploadTime();
  scene.Window->SetSize(120, 90);
  const InkTestImage small(scene.Window);
  EXPECT_TRUE(small.GetWidth() == 120 && small.CountDark() > 30) << "stipples in a smaller window";
  scene.Window->SetSize(200, 200);
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(first), 0) << "the first picture again";
  scene.Mapper->SetBoundaryGain(3.0);
  scene.Mapper->SetStippleSize(3.0);
  scene.Mapper->SetWarmCool(0.5);
  scene.Renderer->GetActiveCamera()->Azimuth(30.0);
  EXPECT_GT(InkTestImage(scene.Window).CountDifferent(first), 500) << "another picture";
  EXPECT_EQ(scene.Mapper->GetUploadTime(), time) << "no upload for any of this";

  StippleScene again(Voxels());
  again.Window->Render();
  again.Mapper->ReleaseGraphicsResources(again.Window);
  EXPECT_EQ(again.Mapper->GetUploadTime(), 0) << "nothing on the GPU";
  EXPECT_EQ(InkTestImage(again.Window).CountDifferent(first), 0) << "the picture after a release";

  StippleScene smooth(Voxels());
  smooth.Window->SetMultiSamples(4);
  const double ink = InkTestImage(smooth.Window).Ink();
  EXPECT_LT(std::abs(ink / first.Ink() - 1.0), 0.05)
    << "as much ink with multisampling: " << ink << ", " << first.Ink();

  StippleScene peeled(Voxels());
  peeled.Renderer->SetUseDepthPeeling(true);
  peeled.Renderer->SetMaximumNumberOfPeels(20);
  peeled.Renderer->SetOcclusionRatio(0.0);
  const InkTestImage peeledImage(peeled.Window);
  EXPECT_LT(peeledImage.CountDifferent(first, 30), 40)
    << "the picture with depth peeling, " << peeledImage.CountDifferent(first, 30) << " pixels differ";

  // Tiles: the same picture, twice as large, without seams.
  StippleScene tiled(Voxels());
  tiled.Mapper->SetStippleSize(6.0);
  const double one = InkTestImage(tiled.Window).Ink();
  const InkTestImage tiles(tiled.Window, 2);
  EXPECT_LT(std::abs(tiles.Ink() / one / 4.0 - 1.0), 0.05)
    << "four times the ink at twice the size: " << tiles.Ink() / one;
  int jumps = 0;
  int usual = 0;
  for (int y = 0; y < 400; ++y)
  {
    jumps += std::abs(tiles.Gray(199, y) - tiles.Gray(200, y)) > 100;
    usual += std::abs(tiles.Gray(180, y) - tiles.Gray(181, y)) > 100;
  }
  EXPECT_LE(jumps, usual + 12) << "no seam between tiles: " << jumps << " jumps, " << usual << " elsewhere";

  // Viewports: each as if it were alone.
  StippleScene alone(Voxels(), 100, 200);
  const InkTestImage expected(alone.Window);
  StippleScene both(Voxels());
  EXPECT_EQ(CountDifferentInViewports(expected, both, both.Actor, 2), 0) << "two viewports like one";
}

/// What is out of sight or gets no stipples is not even processed, and the picture does not miss it.
TEST(StippleScene, Culling)
{
  auto voxels = InkTestStipples::SphereVoxels(1.0, 0.04, 16);
  StippleScene scene(voxels);
  scene.Window->Render();
  const vtkIdType far = scene.Mapper->GetNumberOfProcessedStipples();
  EXPECT_TRUE(far > 0 && far < voxels->GetNumberOfPoints() / 2)
    << "few of " << voxels->GetNumberOfPoints() << " stipples where voxels are small: " << far;
  scene.Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, 1.3);
  scene.Renderer->ResetCameraClippingRange();
  scene.Window->Render();
  const vtkIdType close = scene.Mapper->GetNumberOfProcessedStipples();
  EXPECT_TRUE(close > 0 && close < voxels->GetNumberOfPoints() / 2)
    << "few of " << voxels->GetNumberOfPoints() << " where most are out of sight: " << close;

  // Groups of elements that face away are left out, too, and nothing but them. Stretched along the view, the
  // picture is the same, but what angles the groups have is not known any more.
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, 5.0);
  scene.Renderer->GetActiveCamera()->SetParallelScale(1.2);
  scene.Renderer->ResetCameraClippingRange();
  scene.Mapper->DistanceOff();
  scene.Mapper->SetPixelsPerStipple(2.0);
  const InkTestImage culled(scene.Window);
  const vtkIdType kept = scene.Mapper->GetNumberOfProcessedStipples();
  scene.Actor->SetScale(1.0, 1.0, 1.003);
  scene.Renderer->ResetCameraClippingRange();
  const InkTestImage whole(scene.Window);
  const vtkIdType all = scene.Mapper->GetNumberOfProcessedStipples();
  EXPECT_LT(kept, 0.8 * all) << "those that face away left out: " << kept << " of " << all;
  EXPECT_TRUE(culled.Ink() > 1000.0 && whole.CountDifferent(culled, 12) == 0)
    << "the same picture, but for " << whole.CountDifferent(culled, 12) << " pixels";
  scene.Actor->SetScale(1.0, 1.0, 1.0);

  scene.Mapper->SetBoundaryBase(0.0);
  scene.Mapper->SetBoundaryGain(0.0);
  EXPECT_EQ(InkTestImage(scene.Window).Ink(), 0.0) << "no ink with T = 0";
  EXPECT_EQ(scene.Mapper->GetNumberOfProcessedStipples(), 0) << "nothing processed with T = 0";
}

TEST(StippleScene, Selection)
{
  auto stipples = InkTestStipples::SphereSurface(1.0, 2000, 8);
  StippleScene scene(stipples);
  scene.AllOff();
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(1.25);
  const InkTestImage before(scene.Window);
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  selector->SetArea(110, 90, 129, 109);
  auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  ASSERT_EQ(selection->GetNumberOfNodes(), 1u) << "one prop selected";
  auto* ids = vtkIdTypeArray::SafeDownCast(selection->GetNode(0)->GetSelectionList());
  EXPECT_GT(ids->GetNumberOfTuples(), 5) << "several stipples, " << ids->GetNumberOfTuples();
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    double p[3];
    stipples->GetPoint(ids->GetValue(i), p);
    const double x = 100.0 + 80.0 * p[0];
    const double y = 100.0 + 80.0 * p[1];
    EXPECT_TRUE(p[2] > 0.0 && x > 107.0 && x < 133.0 && y > 87.0 && y < 113.0)
      << "stipple " << ids->GetValue(i) << " in the area and on the front, at " << x << ", " << y;
  }
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(before), 0) << "the same picture afterwards";
}

/// The same picture of stipples that are scaled and shifted together with the camera.
TEST(StippleScene, ScaleAndShift)
{
  auto local = Voxels();
  StippleScene reference(local);
  const InkTestImage expected(reference.Window);
  const double far = 1e7;
  const struct
  {
    double Scale;
    double Shift[3];
  } cases[] = { { 1.0, { far, -far, far } }, { 1e-9, { 0, 0, 0 } }, { 1e9, { far, far, far } } };
  for (const auto& one : cases)
  {
    StippleScene scene(InkTestStipples::Transform(local, one.Scale, one.Shift));
    vtkCamera* from = reference.Renderer->GetActiveCamera();
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    double position[3];
    double focus[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      position[axis] = one.Scale * from->GetPosition()[axis] + one.Shift[axis];
      focus[axis] = one.Scale * from->GetFocalPoint()[axis] + one.Shift[axis];
    }
    camera->SetPosition(position);
    camera->SetFocalPoint(focus);
    camera->SetClippingRange(
      one.Scale * from->GetClippingRange()[0], one.Scale * from->GetClippingRange()[1]);
    const int different = InkTestImage(scene.Window).CountDifferent(expected, 40);
    EXPECT_LT(different, 40) << "the local picture at scale " << one.Scale << ", shifted by " << one.Shift[0]
                             << ": " << different << " pixels differ";
  }
}

TEST(StippleScene, ClippingPlanes)
{
  StippleScene scene(InkTestStipples::PlaneSurface(2.0, 30, 8));
  scene.AllOff();
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(1.0);
  vtkNew<vtkPlane> right;
  right->SetNormal(1.0, 0.0, 0.0);
  scene.Mapper->AddClippingPlane(right);
  const InkTestImage image(scene.Window);
  EXPECT_TRUE(image.CountDark(0, 0, 98, 200) == 0 && image.CountDark(102, 0, 200, 200) > 500)
    << "stipples right of a clipping plane only";

  // What is cut off of the surface that hides stipples hides none.
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(80);
  sphere->SetPhiResolution(80);
  sphere->SetRadius(1.0);
  sphere->Update();
  StippleScene hidden(InkTestStipples::SphereSurface(1.0, 800, 8));
  hidden.AllOff();
  hidden.Mapper->SetSurfaceData(sphere->GetOutput());
  const double closed = InkTestImage(hidden.Window).Ink();
  vtkNew<vtkPlane> back;
  back->SetNormal(0.0, 0.0, -1.0);
  hidden.Mapper->AddClippingPlane(back);
  const double open = InkTestImage(hidden.Window).Ink();
  EXPECT_TRUE(closed > 1000.0 && open > 0.8 * closed)
    << "the back's stipples seen through the open front: ink " << open << " of " << closed;
}
