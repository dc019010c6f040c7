// SPDX-License-Identifier: BSD-3-Clause
// Strokes of odd data, what is said of it, and parameters by name.
#include "InkTestImage.h"
#include "InkTestMessages.h"
#include "StrokeScene.h"

#include "vtkFloatArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

namespace
{

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();

} // namespace

TEST(StrokeInput, OddData)
{
  const struct
  {
    const char* Name;
    vtkSmartPointer<vtkPolyData> Data;
    const char* Message; ///< null: none
  } cases[] = {
    { "nothing", vtkSmartPointer<vtkPolyData>::New(), nullptr },
    { "one point", MakeStrokes({ { { 100.0, 100.0, 0.0 } } }), "two different points" },
    { "a point twice", MakeStrokes({ { { 100.0, 100.0, 0.0 }, { 100.0, 100.0, 0.0 } } }),
      "two different points" },
    { "no finite point", MakeStrokes({ { { noNumber, 0.0, 0.0 }, { noNumber, 0.0, 0.0 } } }), nullptr },
  };
  for (const auto& one : cases)
  {
    StrokeScene scene(one.Data);
    scene.LookAtPixels();
    vtkNew<InkTestMessages> messages;
    messages->Observe(scene.Mapper);
    EXPECT_EQ(InkTestImage(scene.Window).Ink(), 0.0) << one.Name;
    scene.Window->Render();
    messages->Expect(
      one.Name, one.Message ? std::vector<std::string>{ one.Message } : std::vector<std::string>{});
  }

  const auto points = vtkSmartPointer<vtkPolyData>::New();
  points->SetPoints(MakeStrokes({ { { 1.0, 1.0, 0.0 }, { 2.0, 2.0, 0.0 } } })->GetPoints());
  StrokeScene scene(points);
  vtkNew<InkTestMessages> messages;
  messages->Observe(scene.Mapper);
  scene.Window->Render();
  scene.Window->Render();
  messages->Expect("points without lines", { "lines", "2 points" });
}

/// A point that is not finite divides a stroke; repeated points change nothing.
TEST(StrokeInput, OddPoints)
{
  StrokeScene whole(MakeStrokes({ { { 20.0, 100.0, 0.0 }, { 180.0, 100.0, 0.0 } } }));
  StrokeScene repeated(MakeStrokes({ { { 20.0, 100.0, 0.0 }, { 20.0, 100.0, 0.0 }, { 90.0, 100.0, 0.0 },
    { 90.0, 100.0, 0.0 }, { 180.0, 100.0, 0.0 }, { 180.0, 100.0, 0.0 } } }));
  StrokeScene divided(MakeStrokes({ { { 20.0, 100.0, 0.0 }, { 80.0, 100.0, 0.0 }, { noNumber, 100.0, 0.0 },
    { 120.0, 100.0, 0.0 }, { 180.0, 100.0, 0.0 } } }));
  for (StrokeScene* scene : { &whole, &repeated, &divided })
  {
    scene->LookAtPixels();
    scene->Mapper->SetLineWidth(4.0);
    scene->Mapper->SetCapToButt();
  }
  const InkTestImage expected(whole.Window);
  EXPECT_EQ(InkTestImage(repeated.Window).CountDifferent(expected, 1), 0);
  const InkTestImage image(divided.Window);
  EXPECT_NEAR(image.Ink(), 120.0 * 4.0, 1.0);
  EXPECT_EQ(image.CountDark(82, 0, 118, 200), 0) << "nothing between the parts";
}

/// A stroke seen from its end is a dot; one that goes past the eye ends at the near plane.
TEST(StrokeInput, OddViews)
{
  StrokeScene end(
    MakeStrokes({ { { 100.0, 100.0, -50.0 }, { 100.0, 100.0, 0.0 }, { 100.0, 100.0, 50.0 } } }));
  end.LookAtPixels();
  end.Mapper->SetLineWidth(10.0);
  EXPECT_NEAR(InkTestImage(end.Window).Ink(), 78.5, 3.0) << "a dot of 10 pixels";

  StrokeScene past(MakeStrokes({ { { 0.0, -1.0, -10.0 }, { 0.0, -1.0, 10.0 } } }));
  past.Mapper->SetLineWidth(6.0);
  vtkCamera* camera = past.Renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 0.0);
  camera->SetFocalPoint(0.0, 0.0, -1.0);
  camera->SetViewAngle(90.0);
  camera->SetClippingRange(0.1, 100.0);
  const InkTestImage image(past.Window);
  // From the lower edge to 1/10 below the middle, a tenth of the way from there to the edge.
  EXPECT_NEAR(image.Ink(), 6.0 * 90.0, 40.0);
  EXPECT_TRUE(
    image.IsDark(100, 0) && image.IsDark(100, 80) && !image.IsDark(100, 96) && !image.IsDark(100, 150));
}

TEST(StrokeInput, Arrays)
{
  for (const char* name : { "Normals", "ArcLength", "RadialCurvature", "Width", "Priority" })
  {
    const auto data = MakeStrokes({ { { 20.0, 100.0, 0.0 }, { 180.0, 100.0, 0.0 } } });
    vtkNew<vtkFloatArray> wrong;
    wrong->SetName(name);
    wrong->SetNumberOfComponents(2);
    wrong->SetNumberOfTuples(2);
    wrong->Fill(1.0);
    data->GetPointData()->AddArray(wrong);
    StrokeScene scene(data);
    vtkNew<InkTestMessages> messages;
    messages->Observe(scene.Mapper);
    EXPECT_EQ(InkTestImage(scene.Window).Ink(), 0.0);
    scene.Window->Render();
    messages->Expect(name, { name, "2 components", "Expected" });
  }
  // Arc length that begins elsewhere shifts dashes, as far as it is finite.
  const auto data = MakeStrokes({ { { 20.0, 100.0, 0.0 }, { 180.0, 100.0, 0.0 } } });
  vtkNew<vtkFloatArray> arcLength;
  arcLength->SetName("ArcLength");
  arcLength->InsertNextValue(0.0f);
  arcLength->InsertNextValue(320.0f);
  data->GetPointData()->AddArray(arcLength);
  StrokeScene scene(data);
  scene.LookAtPixels();
  scene.Mapper->SetLineWidth(3.0);
  scene.Mapper->DashedOn();
  scene.Mapper->SetDashLength(20.0);
  scene.Mapper->SetGapLength(20.0);
  scene.Mapper->SetCapToButt();
  const InkTestImage image(scene.Window);
  for (int x = 20; x < 180; ++x)
  {
    EXPECT_EQ(image.IsDark(x, 100), (x - 20) % 20 < 10) << "dashes of 10 pixels by the array, at " << x;
  }
}

TEST(StrokeInput, Parameters)
{
  vtkNew<vtkInkStrokeMapper> mapper;
  vtkNew<InkTestMessages> messages;
  messages->Observe(mapper);
  mapper->SetLineWidth(-3.0);
  mapper->SetMiterLimit(0.0);
  mapper->SetTaper(7.0);
  EXPECT_EQ(mapper->GetLineWidth(), 0.0);
  EXPECT_EQ(mapper->GetMiterLimit(), 1.0);
  EXPECT_EQ(mapper->GetTaper(), 1.0);
  messages->Expect("clamped", {});
  mapper->SetLift(noNumber);
  EXPECT_EQ(mapper->GetLift(), 2.0);
  messages->Expect("no number", { "Lift", "nan" });

  mapper->SetSizeUnitToWorld();
  mapper->SetJoinToMiter();
  mapper->SetCapToButt();
  mapper->SetHiddenPartsToDashed();
  mapper->SetSurfaceData(MakeStrokes({}));
  mapper->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Own");
  mapper->DashedOn();
  mapper->SetDashLength(3.0);
  mapper->SetGapLength(4.0);
  mapper->SetDepthWidth(0.5);
  mapper->SetDensity(0.25);
  mapper->SetInkColor(0.1, 0.2, 0.3);
  mapper->SetLift(5.0);
  mapper->SetDepthTolerance(0.5);
  mapper->SetHiddenOpacity(0.6);
  mapper->SetShortestPart(9.0);
  vtkNew<vtkInkStrokeMapper> copy;
  copy->ShallowCopy(mapper);
  const auto print = [](vtkInkStrokeMapper* printed)
  {
    std::ostringstream text;
    printed->PrintSelf(text, vtkIndent());
    const std::string whole = text.str();
    return whole.substr(whole.find("SizeUnit"));
  };
  EXPECT_EQ(print(copy), print(mapper));
  for (const char* text : { "SizeUnit: World", "Join: Miter", "Cap: Butt", "HiddenParts: Dashed",
         "LineWidth: 0", "DepthTolerance: 0.5", "ShortestPart: 9", "InkColor: 0.1 0.2 0.3" })
  {
    EXPECT_NE(print(mapper).find(text), std::string::npos) << text;
  }
  EXPECT_EQ(copy->GetInputDataObject(1, 0), mapper->GetInputDataObject(1, 0));
}

/// Strokes are sent once; parameters and cameras send nothing.
TEST(StrokeInput, Uploads)
{
  const auto data = MakeStrokes({ { { 20.0, 100.0, 0.0 }, { 180.0, 100.0, 0.0 } } });
  StrokeScene scene(data);
  scene.LookAtPixels();
  EXPECT_EQ(scene.Mapper->GetUploadTime(), 0u);
  const InkTestImage first(scene.Window);
  const vtkMTimeType time = scene.Mapper->GetUploadTime();
  EXPECT_GT(time, 0u);
  scene.Mapper->SetLineWidth(5.0);
  scene.Mapper->SetTaper(0.4);
  scene.Renderer->GetActiveCamera()->Azimuth(20.0);
  scene.Window->Render();
  EXPECT_EQ(scene.Mapper->GetUploadTime(), time);
  data->GetPoints()->SetPoint(0, 20.0, 50.0, 0.0);
  data->GetPoints()->Modified();
  scene.Window->Render();
  EXPECT_GT(scene.Mapper->GetUploadTime(), time);
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  EXPECT_EQ(scene.Mapper->GetUploadTime(), 0u);
  EXPECT_GT(InkTestImage(scene.Window).CountDark(), 100) << "again after a release";
}
