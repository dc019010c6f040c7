// SPDX-License-Identifier: BSD-3-Clause
// What mappers share, with a mapper that draws a dot for each point.
#include "DotsMapper.h"
#include "InkTestImage.h"
#include "InkTestMessages.h"
#include "InkTestScene.h"
#include "InkVertexLimit.h"

#include "vtkCoordinate.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace
{

using Scene = InkTestScene<DotsMapper>;

/// A row of points along x, far from the origin, from -1 to 1 around it.
vtkSmartPointer<vtkPolyData> Row(int count)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < count; ++i)
  {
    points->InsertNextPoint(1e6 + 2.0 * i / (count - 1) - 1.0, 0.0, 0.0);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  return data;
}

/// The ids of the row's dots in the picture, by whether its pixels are dark there.
std::set<int> FindDrawn(Scene& scene)
{
  const InkTestImage image(scene.Window);
  std::set<int> drawn;
  vtkPolyData* data = scene.Mapper->GetInput();
  for (int i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    if (!std::isfinite(data->GetPoint(i)[0]))
    {
      continue;
    }
    vtkNew<vtkCoordinate> coordinate;
    coordinate->SetCoordinateSystemToWorld();
    coordinate->SetValue(data->GetPoint(i));
    const int* pixel = coordinate->GetComputedViewportValue(scene.Renderer);
    if (image.IsDark(pixel[0], pixel[1]))
    {
      drawn.insert(i);
    }
  }
  return drawn;
}

std::set<int> Ids(int first, int last)
{
  std::set<int> ids;
  for (int i = first; i <= last; ++i)
  {
    ids.insert(i);
  }
  return ids;
}

} // namespace

TEST(InkMapper, Dots)
{
  Scene scene(Row(7));
  EXPECT_EQ(FindDrawn(scene), Ids(0, 6)) << "all dots";
  const int dark = InkTestImage(scene.Window).CountDark();
  const double expected = 7 * 0.25 * vtkMath::Pi() * 81.0;
  EXPECT_LT(std::abs(dark - expected), 0.1 * expected)
    << "dots of a diameter of 9, " << expected << " pixels, found " << dark;
  scene.Actor->VisibilityOff();
  EXPECT_TRUE(FindDrawn(scene).empty()) << "no dots of what is not visible";
}

TEST(InkMapper, AnotherDrawsOverIt)
{
  Scene scene(Row(7));
  vtkNew<DotsMapper> over;
  over->SetInputData(Row(3));
  over->InkColor[0] = over->InkColor[1] = over->InkColor[2] = 1.0;
  scene.Mapper->SetOverlay(over);
  EXPECT_EQ(FindDrawn(scene), (std::set<int>{ 1, 2, 4, 5 })) << "white dots over the first, middle and last";
  const vtkMTimeType before = scene.Mapper->GetMTime();
  over->Modified();
  EXPECT_GT(scene.Mapper->GetMTime(), before);
  vtkNew<vtkPlane> left;
  left->SetOrigin(1e6 - 0.5, 0.0, 0.0);
  left->SetNormal(1.0, 0.0, 0.0);
  scene.Mapper->AddClippingPlane(left);
  EXPECT_EQ(FindDrawn(scene), (std::set<int>{ 2, 4, 5 }));
  EXPECT_EQ(over->GetClippingPlanes(), scene.Mapper->GetClippingPlanes());
  scene.Mapper->RemoveAllClippingPlanes();
  over->SetInputDataObject(nullptr);
  EXPECT_EQ(FindDrawn(scene), Ids(0, 6)) << "nothing over it";
  // Ids are those of the points below.
  over->SetInputData(Row(3));
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  const int* size = scene.Window->GetSize();
  selector->SetArea(0, 0, static_cast<unsigned int>(size[0] - 1), static_cast<unsigned int>(size[1] - 1));
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  ASSERT_EQ(selection->GetNumberOfNodes(), 1u);
  EXPECT_EQ(selection->GetNode(0)->GetSelectionList()->GetNumberOfTuples(), 7);
  scene.Mapper->SetOverlay(nullptr);
  EXPECT_EQ(FindDrawn(scene), Ids(0, 6));
}

TEST(InkMapper, BoundsHoldWhatIsDrawnOverIt)
{
  Scene scene(Row(7));
  const vtkSmartPointer<vtkPolyData> far = Row(3);
  far->GetPoints()->SetPoint(0, 1e6 + 9.0, 4.0, -5.0);
  vtkNew<DotsMapper> over;
  scene.Mapper->SetOverlay(over);
  const auto expect = [&](const std::array<double, 6>& expected, const char* what)
  {
    const double* bounds = scene.Mapper->GetBounds();
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), bounds)) << what;
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), scene.Actor->GetBounds())) << what;
  };
  expect({ 1e6 - 1.0, 1e6 + 1.0, 0.0, 0.0, 0.0, 0.0 }, "nothing over it");
  over->SetInputData(far);
  expect({ 1e6 - 1.0, 1e6 + 9.0, 0.0, 4.0, -5.0, 0.0 }, "both");
  // A camera that is reset shows what lies beside the marks.
  scene.Renderer->ResetCamera();
  const InkTestImage image(scene.Window);
  vtkNew<vtkCoordinate> coordinate;
  coordinate->SetCoordinateSystemToWorld();
  coordinate->SetValue(far->GetPoint(0));
  const int* pixel = coordinate->GetComputedViewportValue(scene.Renderer);
  EXPECT_TRUE(image.IsDark(pixel[0], pixel[1])) << pixel[0] << ", " << pixel[1];
  scene.Mapper->SetInputDataObject(nullptr);
  expect({ 1e6, 1e6 + 9.0, 0.0, 4.0, -5.0, 0.0 }, "only what is over nothing");
  over->SetInputData(Row(0));
  EXPECT_FALSE(vtkMath::AreBoundsInitialized(scene.Mapper->GetBounds())) << "without points";
}

TEST(InkMapper, Clipping)
{
  Scene scene(Row(7));
  vtkNew<InkTestMessages> messages;
  messages->Observe(scene.Mapper);
  vtkNew<vtkPlane> left;
  left->SetOrigin(1e6 - 0.5, 0.0, 0.0);
  left->SetNormal(1.0, 0.0, 0.0);
  scene.Mapper->AddClippingPlane(left);
  EXPECT_EQ(FindDrawn(scene), Ids(2, 6)) << "the dots right of a plane";
  vtkNew<vtkPlane> right;
  right->SetOrigin(1e6 + 0.5, 0.0, 0.0);
  right->SetNormal(-1.0, 0.0, 0.0);
  scene.Mapper->AddClippingPlane(right);
  EXPECT_EQ(FindDrawn(scene), Ids(2, 4)) << "those between two";
  messages->Expect("planes", {});
  for (int i = 0; i < 4; ++i)
  {
    scene.Mapper->AddClippingPlane(right);
  }
  vtkNew<vtkPlane> seventh;
  seventh->SetOrigin(1e6, 0.0, 0.0);
  seventh->SetNormal(1.0, 0.0, 0.0);
  scene.Mapper->AddClippingPlane(seventh);
  EXPECT_EQ(FindDrawn(scene), Ids(2, 4)) << "as if there were no seventh plane";
  scene.Window->Render();
  messages->Expect("seven planes", { "6", "7", "clipping planes" });
}

TEST(InkMapper, Selection)
{
  Scene scene(Row(300));
  scene.Window->Render();
  const auto select = [&](int association)
  {
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(scene.Renderer);
    selector->SetArea(0, 0, 199, 199);
    selector->SetFieldAssociation(association);
    vtkSmartPointer<vtkSelection> selection;
    selection.TakeReference(selector->Select());
    std::vector<vtkIdType> ids;
    for (unsigned int i = 0; i < selection->GetNumberOfNodes(); ++i)
    {
      vtkSelectionNode* node = selection->GetNode(i);
      EXPECT_EQ(node->GetProperties()->Get(vtkSelectionNode::PROP()), scene.Actor.Get()) << "the actor";
      auto* list = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
      ids.insert(ids.end(), list->GetPointer(0), list->GetPointer(0) + list->GetNumberOfTuples());
    }
    return ids;
  };
  const std::vector<vtkIdType> points = select(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  // Each of the dots shows a part that no other covers, but for the last.
  EXPECT_TRUE(points.size() >= 299 && points.front() <= 1 && points.back() == 299)
    << "points 0 to 299, found " << points.size() << " up to " << (points.empty() ? -1 : points.back());
  const std::vector<vtkIdType> cells = select(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  EXPECT_TRUE(std::all_of(cells.begin(), cells.end(), [](vtkIdType id) { return id <= 0; })) << "no cells";
}

/// The points are sent once to each window, and what a window has goes with it, or with the mapper.
TEST(InkMapper, Windows)
{
  const auto row = Row(7);
  {
    Scene scene(row);
    EXPECT_EQ(scene.Mapper->GetUploadTime(), 0) << "no upload before the first picture";
    scene.Window->Render();
    const vtkMTimeType first = scene.Mapper->GetUploadTime();
    scene.Renderer->GetActiveCamera()->Azimuth(10.0);
    scene.Mapper->Diameter = 5.0;
    scene.Mapper->Modified();
    scene.Window->Render();
    EXPECT_TRUE(first > 0 && scene.Mapper->GetUploadTime() == first) << "one upload for several pictures";
    row->GetPoints()->SetPoint(0, 1e6, 0.3, 0.0);
    row->GetPoints()->Modified();
    scene.Window->Render();
    EXPECT_GT(scene.Mapper->GetUploadTime(), first) << "another one for other points";

    {
      vtkNew<vtkActor> actor;
      actor->SetMapper(scene.Mapper);
      vtkNew<vtkRenderer> renderer;
      renderer->SetBackground(1.0, 1.0, 1.0);
      renderer->AddActor(actor);
      vtkNew<vtkRenderWindow> other;
      other->SetOffScreenRendering(true);
      other->SetMultiSamples(0);
      other->SetSize(100, 100);
      other->AddRenderer(renderer);
      renderer->ResetCamera();
      EXPECT_GT(InkTestImage(other).CountDark(), 50) << "dots in a second window";
      EXPECT_EQ(DotsMapper::NumberOfMarks, 2) << "marks in two windows, found " << DotsMapper::NumberOfMarks;
    }
    EXPECT_EQ(DotsMapper::NumberOfMarks, 1)
      << "one after the second is gone, found " << DotsMapper::NumberOfMarks;
    scene.Mapper->ReleaseGraphicsResources(scene.Window);
    EXPECT_EQ(DotsMapper::NumberOfMarks, 0) << "none when released, found " << DotsMapper::NumberOfMarks;
    EXPECT_TRUE(scene.Mapper->GetUploadTime() == 0 && InkTestImage(scene.Window).CountDark() > 50)
      << "dots again after that";
    EXPECT_EQ(DotsMapper::NumberOfMarks, 1) << "marks again, found " << DotsMapper::NumberOfMarks;
  }
  EXPECT_EQ(DotsMapper::NumberOfMarks, 0) << "none at the end, found " << DotsMapper::NumberOfMarks;
}

TEST(InkMapper, Input)
{
  {
    Scene scene(nullptr);
    vtkNew<InkTestMessages> messages;
    messages->Observe(scene.Mapper);
    EXPECT_FALSE(vtkMath::AreBoundsInitialized(scene.Mapper->GetBounds())) << "no bounds without input";
    EXPECT_EQ(InkTestImage(scene.Window).CountDark(), 0) << "nothing without input";
    messages->Expect("no input", {});
  }
  const auto row = Row(3);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  row->GetPoints()->SetPoint(1, nan, 0.0, 0.0);
  {
    Scene scene(row);
    const double* bounds = scene.Mapper->GetBounds();
    EXPECT_TRUE(bounds[0] == 1e6 - 1.0 && bounds[1] == 1e6 + 1.0 && bounds[2] == 0.0)
      << "bounds of finite points";
    EXPECT_EQ(FindDrawn(scene), (std::set<int>{ 0, 2 })) << "the finite dots";
  }
  Scene scene(row);
  vtkNew<InkTestMessages> messages;
  messages->Observe(scene.Mapper);
  scene.Mapper->Diameter = 0.0;
  scene.Window->Render();
  scene.Window->Render();
  messages->Expect("one message for two pictures", { "diameter" });
  messages->Messages.clear();
  row->Modified();
  scene.Window->Render();
  messages->Expect("another one for another input", { "diameter" });
}

TEST(InkMapper, TooManyVertices)
{
  constexpr std::size_t most = std::numeric_limits<int>::max();
  for (const std::size_t count : { std::size_t{ 0 }, most / 3, most })
  {
    EXPECT_EQ(InkFindVertexProblem(count), "") << count;
  }
  for (const std::size_t count : { most + 1, 2 * most + 2, 8 * most })
  {
    const std::string problem = InkFindVertexProblem(count);
    EXPECT_NE(problem.find(std::to_string(count)), std::string::npos) << count << ": " << problem;
  }
}
