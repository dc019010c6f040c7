// SPDX-License-Identifier: BSD-3-Clause
#include "ContourUpdates.h"
#include "InkTestImage.h"
#include "InkTestMessages.h"
#include "InkTestScene.h"
#include "InkUploadEvent.h"
#include "SilhouetteOfUnitBall.h"
#include "TubeSurfaces.h"
#include "vtkInkSilhouetteMapper.h"

#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkPlaneSource.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSphereSource.h"
#include "vtkTimerLog.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

namespace
{

class Scene : public InkTestScene<vtkInkSilhouetteMapper>
{
public:
  explicit Scene(vtkPolyData* data, int size = 200)
    : InkTestScene(data, size, size)
  {
    this->Mapper->SetSizeUnitToPixels();
    this->Mapper->SetLineWidth(3.0);
  }
  vtkPolyData* GetContours() { return this->Mapper->GetContours(this->Renderer, this->Actor); }
};

vtkSmartPointer<vtkPolyData> Sphere()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(64);
  sphere->Update();
  return sphere->GetOutput();
}

vtkSmartPointer<vtkPolyData> Cube()
{
  vtkNew<vtkCubeSource> cube;
  cube->Update();
  cube->GetOutput()->GetPointData()->SetNormals(nullptr);
  return cube->GetOutput();
}

} // namespace

/// A sphere's outline is a circle, whichever way the camera looks.
TEST(SilhouetteMapper, Sphere)
{
  for (const bool parallel : { false, true })
  {
    Scene scene(Sphere());
    ExpectOutlineOfUnitBall(scene, parallel);
  }
}

/// Waves of a sheet have an outline each, wherever the sheet ends: it encloses nothing that could hide them.
TEST(SilhouetteMapper, OpenSheet)
{
  constexpr int waves = 4;
  for (const double phase : { 0.0, 0.25, 0.5, 0.75 })
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(0.0, -2.0, 0.0);
    plane->SetPoint1(waves, -2.0, 0.0);
    plane->SetPoint2(0.0, 2.0, 0.0);
    plane->SetResolution(200, 10);
    plane->Update();
    vtkPolyData* sheet = plane->GetOutput();
    for (vtkIdType i = 0; i < sheet->GetNumberOfPoints(); ++i)
    {
      double p[3];
      sheet->GetPoint(i, p);
      const double angle = 2.0 * std::numbers::pi * (p[0] + phase);
      p[2] = 0.15 * std::sin(angle);
      sheet->GetPoints()->SetPoint(i, p);
      sheet->GetPointData()->GetNormals()->SetTuple3(i, -0.3 * std::numbers::pi * std::cos(angle), 0.0, 1.0);
    }
    Scene scene(sheet);
    scene.Mapper->BordersOff();
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.2);
    camera->SetFocalPoint(0.5 * waves, 0.0, 0.0);
    camera->SetPosition(0.5 * waves + 10.0, 0.0, 3.64);
    camera->SetViewUp(0.0, 0.0, 1.0);
    scene.Renderer->ResetCameraClippingRange();
    const InkTestImage image(scene.Window);
    int lines = 0;
    for (int y = 1; y < 200; ++y)
    {
      lines += image.IsDark(100, y) && !image.IsDark(100, y - 1);
    }
    // Where the sheet ends on its way up or down from the nearest crest, the eye sees the hollow below.
    EXPECT_EQ(lines, waves + (phase < 0.5 ? 1 : 0)) << phase;
  }
}

/// Contours are found again when the camera, the actor, the data or an option changes, and not otherwise.
TEST(SilhouetteMapper, Updates)
{
  const auto sphere = Sphere();
  Scene scene(sphere);
  EXPECT_EQ(scene.GetContours(), nullptr);
  ContourUpdates expect(scene);
  expect.ExpectThoseOfTheView();
  scene.Mapper->CreasesOn();
  expect(true, "another option");
  sphere->GetPoints()->SetPoint(5, 0.0, 0.0, 1.1);
  sphere->GetPoints()->Modified();
  expect(true, "another surface");
  expect(false, "the same picture again");
}

/// The visible edges of a cube, and the others faint or dashed.
TEST(SilhouetteMapper, HiddenParts)
{
  Scene scene(Cube());
  vtkNew<InkTestMessages> messages;
  messages->Observe(scene.Mapper);
  scene.Mapper->SilhouettesOff();
  scene.Mapper->BordersOff();
  scene.Mapper->CreasesOn();
  scene.Mapper->SetInputData(Cube());
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetPosition(1.3, 1.9, 3.1);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetParallelScale(0.95);
  scene.Renderer->ResetCameraClippingRange();
  const double visible = InkTestImage(scene.Window).Ink();
  ASSERT_GE(scene.GetContours()->GetNumberOfLines(), 1);
  scene.Mapper->SetHiddenPartsToFaint();
  scene.Mapper->SetHiddenOpacity(1.0);
  const double all = InkTestImage(scene.Window).Ink();
  scene.Mapper->SetHiddenOpacity(0.4);
  const double faint = InkTestImage(scene.Window).Ink();
  scene.Mapper->SetHiddenPartsToDashed();
  scene.Mapper->SetDashLength(6.0);
  scene.Mapper->SetGapLength(6.0);
  const double dashed = InkTestImage(scene.Window).Ink();
  scene.Mapper->SetHiddenPartsToOmitted();
  EXPECT_EQ(InkTestImage(scene.Window).Ink(), visible);
  // Three of the twelve edges are hidden; how long the edges are is different.
  const double hidden = all - visible;
  EXPECT_TRUE(hidden > 0.15 * all && hidden < 0.35 * all) << hidden << " of " << all;
  EXPECT_NEAR((faint - visible) / hidden, 0.4, 0.03);
  EXPECT_NEAR((dashed - visible) / hidden, 0.5, 0.06);
}

TEST(SilhouetteMapper, Kinds)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(4, 4);
  plane->Update();
  Scene scene(plane->GetOutput());
  EXPECT_GT(InkTestImage(scene.Window).CountDark(), 100) << "the border of a square";
  auto* kinds =
    vtkUnsignedCharArray::SafeDownCast(scene.GetContours()->GetCellData()->GetArray("ContourKind"));
  ASSERT_EQ(kinds->GetNumberOfTuples(), 1);
  EXPECT_EQ(kinds->GetValue(0), 2);
  scene.Mapper->BordersOff();
  EXPECT_EQ(InkTestImage(scene.Window).Ink(), 0.0) << "and nothing else";
}

TEST(SilhouetteMapper, Selection)
{
  const auto sphere = Sphere();
  Scene scene(sphere);
  scene.Window->Render();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  selector->SetArea(100, 0, 199, 199);
  const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  ASSERT_EQ(selection->GetNumberOfNodes(), 1u);
  auto* ids = vtkIdTypeArray::SafeDownCast(selection->GetNode(0)->GetSelectionList());
  EXPECT_GT(ids->GetNumberOfTuples(), 10);
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    double p[3];
    sphere->GetPoint(ids->GetValue(i), p);
    EXPECT_TRUE(p[0] > -0.15 && std::abs(p[2]) < 0.5) << "beside the right half of the outline";
  }
}

/// The dashed outline of a sphere is the same circle from everywhere: its dashes stay or slide.
TEST(SilhouetteMapper, CoherentDashes)
{
  const auto sphere = Sphere();
  const auto slides = [&](bool coherent)
  {
    Scene scene(sphere);
    scene.Mapper->DashedOn();
    scene.Mapper->SetDashLength(10.0);
    scene.Mapper->SetGapLength(10.0);
    scene.Mapper->SetCoherentDashes(coherent);
    double change = 0.0;
    InkTestImage before(scene.Window);
    const double ink = before.Ink();
    for (int frame = 0; frame < 10; ++frame)
    {
      scene.Renderer->GetActiveCamera()->Azimuth(2.0);
      scene.Renderer->GetActiveCamera()->Elevation(1.0);
      InkTestImage image(scene.Window);
      for (int y = 0; y < 200; ++y)
      {
        for (int x = 0; x < 200; ++x)
        {
          change += std::abs(image.Gray(x, y) - before.Gray(x, y)) / 255.0;
        }
      }
      EXPECT_NEAR(image.Ink() / ink, 1.0, 0.05);
      before = image;
    }
    if (!coherent)
    {
      // Without history the picture is that of a new scene.
      Scene again(sphere);
      again.Mapper->DashedOn();
      again.Mapper->SetDashLength(10.0);
      again.Mapper->SetGapLength(10.0);
      again.Renderer->GetActiveCamera()->DeepCopy(scene.Renderer->GetActiveCamera());
      EXPECT_EQ(InkTestImage(again.Window).CountDifferent(before), 0);
    }
    return change / (10.0 * ink);
  };
  EXPECT_TRUE(vtkNew<vtkInkSilhouetteMapper>()->GetCoherentDashes()) << "by default";
  const double still = slides(true);
  const double sliding = slides(false);
  // Measured: .037 and .556 of the ink a frame.
  EXPECT_LT(still, 0.15 * sliding) << "of " << sliding;
}

/// What dashes were aligned for does not outlast it: another period, or none.
TEST(SilhouetteMapper, CoherentDashesFollowTheirParameters)
{
  const auto sphere = Sphere();
  Scene scene(sphere);
  const auto prepare = [](Scene& prepared)
  {
    prepared.Mapper->DashedOn();
    prepared.Mapper->SetDashLength(10.0);
    prepared.Mapper->SetGapLength(10.0);
  };
  prepare(scene);
  scene.Mapper->CoherentDashesOn();
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.3);
  for (int frame = 0; frame < 5; ++frame)
  {
    camera->Azimuth(4.0);
    scene.Window->Render();
  }
  const auto arcBegin = [&]
  {
    scene.Window->Render();
    return scene.GetContours()->GetPointData()->GetArray("ArcLength")->GetComponent(0, 0);
  };
  EXPECT_NE(arcBegin(), 0.0) << "aligned";
  // Dashes of another period stay as well, from the first motion on: measured 0, and 142 if they did not.
  scene.Mapper->SetGapLength(20.0);
  const InkTestImage longer(scene.Window);
  camera->Azimuth(2.0);
  const InkTestImage moved(scene.Window);
  EXPECT_LE(moved.CountDifferent(longer, 100), 50);
  scene.Mapper->SetGapLength(10.0);

  // No longer coherent, the picture is that of a new scene; nor are lines without dashes aligned.
  Scene again(sphere);
  prepare(again);
  again.Renderer->GetActiveCamera()->DeepCopy(camera);
  const InkTestImage fresh(again.Window);
  scene.Mapper->CoherentDashesOff();
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(fresh), 0);
  scene.Mapper->CoherentDashesOn();
  EXPECT_EQ(arcBegin(), 0.0);
  camera->Azimuth(4.0);
  EXPECT_NE(arcBegin(), 0.0);
  scene.Mapper->DashedOff();
  EXPECT_EQ(arcBegin(), 0.0);
}

/// Each viewport keeps its own contours on the graphics card.
TEST(SilhouetteMapper, ViewportsSendTheirContoursOnce)
{
  Scene scene(Sphere());
  scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  vtkNew<vtkRenderer> right;
  right->SetViewport(0.5, 0.0, 1.0, 1.0);
  right->SetBackground(1.0, 1.0, 1.0);
  right->AddActor(scene.Actor);
  scene.Window->AddRenderer(right);
  right->GetActiveCamera()->SetPosition(3.0, 2.0, 1.0);
  right->ResetCamera();
  const InkTestImage first(scene.Window);
  EXPECT_GT(first.CountDark(0, 0, 100, 200), 100);
  EXPECT_GT(first.CountDark(100, 0, 200, 200), 100);
  const vtkMTimeType before = scene.Mapper->GetUploadTime();
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(first), 0);
  EXPECT_EQ(scene.Mapper->GetUploadTime(), before) << "the same picture";
  right->GetActiveCamera()->Azimuth(5.0);
  scene.Window->Render();
  EXPECT_GT(scene.Mapper->GetUploadTime(), before) << "another camera";
}

/// Strokes have no points of the surface, whose widths there could be.
TEST(SilhouetteMapper, NoWidthsOfPoints)
{
  const auto surface = Sphere();
  surface->GetPointData()->SetNormals(nullptr);
  Scene scene(surface);
  for (int method = vtkInkSilhouetteMapper::CHAINS; method <= vtkInkSilhouetteMapper::TOON; ++method)
  {
    scene.Mapper->SetMethod(method);
    scene.Window->Render();
    vtkNew<vtkFloatArray> widths;
    widths->SetNumberOfTuples(3);
    EXPECT_FALSE(scene.Mapper->EvaluateWidths(scene.Renderer, scene.Actor, widths)) << method;
    EXPECT_EQ(widths->GetNumberOfTuples(), 0) << method;
  }
}

/// Contours of a camera are found and sent in an event of their own, after that of the surface.
TEST(SilhouetteMapper, UploadEvents)
{
  Scene scene(Sphere());
  const auto countEvents = [&]
  {
    vtkTimerLog::ResetLog();
    scene.Window->Render();
    int events = 0;
    bool open = false;
    for (int i = 0; i < vtkTimerLog::GetNumberOfEvents(); ++i)
    {
      if (std::string(vtkTimerLog::GetEventString(i)) == InkUploadEvent)
      {
        const bool starts = vtkTimerLog::GetEventType(i) == vtkTimerLogEntry::START;
        EXPECT_NE(starts, open) << "nothing is counted twice";
        open = starts;
        events += starts;
      }
    }
    EXPECT_FALSE(open);
    return events;
  };
  EXPECT_EQ(countEvents(), 2);
  scene.Mapper->SetMethodToImageSpace();
  EXPECT_EQ(countEvents(), 1);
}
