// SPDX-License-Identifier: BSD-3-Clause
#include "InkTestImage.h"
#include "InkTestMessages.h"
#include "InkTestScene.h"
#include "InkUploadEvent.h"
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
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetParallelProjection(parallel);
    camera->SetPosition(0.0, 0.0, 5.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewAngle(30.0);
    camera->SetParallelScale(1.3);
    scene.Renderer->ResetCameraClippingRange();
    const double radius =
      100.0 * (parallel ? 1.0 / 1.3 : 1.0 / std::sqrt(24.0) / std::tan(15.0 * std::numbers::pi / 180.0));
    for (const double azimuth : { 0.0, 17.0, 90.0 })
    {
      camera->Azimuth(azimuth);
      const InkTestImage image(scene.Window);
      EXPECT_NEAR(image.Ink() / (2.0 * std::numbers::pi * radius * 3.0), 1.0, 0.02)
        << azimuth << ' ' << parallel;
      for (int i = 0; i < 100; ++i)
      {
        const double angle = i * 2.0 * std::numbers::pi / 100;
        const auto darkAt = [&](double r)
        {
          return image.IsDark(
            static_cast<int>(100.0 + r * std::cos(angle)), static_cast<int>(100.0 + r * std::sin(angle)));
        };
        EXPECT_TRUE(darkAt(radius) && !darkAt(radius - 3.0) && !darkAt(radius + 3.0)) << i;
      }
      ASSERT_EQ(scene.GetContours()->GetNumberOfLines(), 1);
    }
  }
}

/// Contours are found again when the camera, the actor, the data or an option changes, and not otherwise.
TEST(SilhouetteMapper, Updates)
{
  const auto sphere = Sphere();
  Scene scene(sphere);
  EXPECT_EQ(scene.GetContours(), nullptr);
  vtkMTimeType before = 0;
  const auto expect = [&](bool anew, const char* what)
  {
    scene.Window->Render();
    EXPECT_EQ(scene.GetContours()->GetMTime() > before, anew) << what;
    before = scene.GetContours()->GetMTime();
  };
  expect(true, "first picture");
  expect(false, "the same picture");
  scene.Mapper->SetLineWidth(5.0);
  scene.Mapper->SetHiddenPartsToFaint();
  expect(false, "another width");
  scene.Renderer->GetActiveCamera()->Azimuth(10.0);
  expect(true, "another camera");
  scene.Actor->RotateX(10.0);
  expect(true, "the actor turned");
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

TEST(SilhouetteMapper, OddSurfaces)
{
  const auto points = vtkSmartPointer<vtkPolyData>::New();
  points->SetPoints(Sphere()->GetPoints());
  Scene none(points);
  vtkNew<InkTestMessages> messages;
  messages->Observe(none.Mapper);
  EXPECT_EQ(InkTestImage(none.Window).Ink(), 0.0);
  none.Window->Render();
  messages->Expect("no polygons", { "polygons", "points" });

  const auto sphere = Sphere();
  const double ink = InkTestImage(Scene(sphere).Window).Ink();
  sphere->GetPointData()->SetNormals(nullptr);
  Scene computed(sphere);
  vtkNew<InkTestMessages> warnings;
  warnings->Observe(computed.Mapper);
  EXPECT_NEAR(InkTestImage(computed.Window).Ink() / ink, 1.0, 0.02);
  computed.Window->Render();
  warnings->Expect("no normals", { "normals", "computed" });

  Scene empty(vtkSmartPointer<vtkPolyData>::New());
  EXPECT_EQ(InkTestImage(empty.Window).Ink(), 0.0);
}

TEST(SilhouetteMapper, Parameters)
{
  vtkNew<vtkInkSilhouetteMapper> mapper;
  mapper->FacetedOn();
  mapper->CreasesOn();
  mapper->SetFeatureAngle(500.0);
  mapper->NonManifoldEdgesOn();
  mapper->CoherentDashesOn();
  mapper->SilhouettesOff();
  mapper->BordersOff();
  mapper->SetLineWidth(7.0);
  mapper->SetMethodToToon();
  mapper->SetLowestValue(1.0);
  mapper->SetHighestValue(2.0);
  mapper->SetLeastGradientMagnitude(3.0);
  mapper->SetLargestCosine(0.4);
  mapper->SetSegmentLength(5.0);
  mapper->ThinningOff();
  mapper->SetTextureLength(6.0);
  vtkNew<vtkImageData> texture;
  mapper->SetTexture(texture);
  vtkNew<vtkInkSilhouetteMapper> copy;
  copy->ShallowCopy(mapper);
  const auto print = [](vtkInkSilhouetteMapper* printed)
  {
    std::ostringstream text;
    printed->PrintSelf(text, vtkIndent());
    const std::string whole = text.str();
    return whole.substr(whole.find("SizeUnit"));
  };
  EXPECT_EQ(print(copy), print(mapper));
  for (const char* text : { "Silhouettes: Off", "Faceted: On", "Creases: On", "FeatureAngle: 180",
         "Borders: Off", "NonManifoldEdges: On", "CoherentDashes: On", "LineWidth: 7", "Method: Toon",
         "LowestValue: 1", "HighestValue: 2", "LeastGradientMagnitude: 3", "LargestCosine: 0.4",
         "SegmentLength: 5", "Thinning: Off", "TextureLength: 6" })
  {
    EXPECT_NE(print(mapper).find(text), std::string::npos) << text;
  }
}
