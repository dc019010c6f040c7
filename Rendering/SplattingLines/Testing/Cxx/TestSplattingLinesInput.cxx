// SPDX-License-Identifier: BSD-3-Clause
// What the input may and may not hold: one clear message, never a crash, and points that cannot be drawn are
// passed over.
#include "InkTestImage.h"
#include "InkTestMessages.h"
#include "InkTestPoints.h"
#include "SplattingLinesScene.h"

#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Three frames of an input that cannot be drawn give an empty picture and one message with all the words.
void TestMessage(const std::string& what, vtkPolyData* points, const std::vector<std::string>& words,
  const std::function<void(vtkInkSplattingLinesMapper*)>& set = {})
{
  SplattingLinesScene scene(points);
  vtkNew<InkTestMessages> messages;
  messages->Observe(scene.Mapper);
  if (set)
  {
    set(scene.Mapper);
  }
  for (int frame = 0; frame < 3; ++frame)
  {
    EXPECT_EQ(InkTestImage(scene.Window).CountDark(255), 0) << "nothing drawn for " << what;
    scene.Renderer->GetActiveCamera()->Azimuth(5.0);
    scene.Mapper->SetPhi(50.0 + frame);
  }
  EXPECT_EQ(messages->Messages.size(), 1)
    << "one message for " << what << ", not " << messages->Messages.size();
  for (const std::string& message : messages->Messages)
  {
    for (const std::string& word : words)
    {
      EXPECT_NE(message.find(word), std::string::npos)
        << "\"" << word << "\" in the message for " << what << ": " << message;
    }
  }

  // The next input is judged anew.
  auto good = InkTestPoints::Sphere(1.0, 0.1);
  scene.Mapper->SetInputData(good);
  scene.Mapper->SetInputArrayToProcess(
    vtkInkSplattingLinesMapper::NORMALS, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Normals");
  scene.Mapper->SetInputArrayToProcess(
    vtkInkSplattingLinesMapper::RADIUS, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Radius");
  scene.Renderer->ResetCamera();
  EXPECT_GT(InkTestImage(scene.Window).CountDark(), 50) << "a picture after " << what;
  EXPECT_EQ(messages->Messages.size(), 1) << "no message for a good input after " << what;
}

void AddArray(vtkPolyData* points, const char* name, int components, double value)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(points->GetNumberOfPoints());
  array->Fill(value);
  points->GetPointData()->AddArray(array);
}

} // namespace

TEST(SplattingLinesInput, Messages)
{
  auto points = InkTestPoints::Sphere(1.0, 0.2);
  points->GetPointData()->RemoveArray("Normals");
  TestMessage("points without arrays", points, { "\"Normals\"", "none" });
  AddArray(points, "Temperature", 1, 0.0);
  TestMessage("points without normals", points, { "\"Normals\"", "\"Temperature\" (1)" });
  AddArray(points, "Normals", 2, 1.0);
  TestMessage("normals of two components", points, { "\"Normals\"", "2 components", "3" });
  AddArray(points, "Normals", 3, 0.0);
  TestMessage("zero normals only", points, { "normal", "zero" });

  points = InkTestPoints::Sphere(1.0, 0.2);
  TestMessage("a chosen array that is missing", points, { "\"Direction\"", "\"Normals\" (3)" },
    [](vtkInkSplattingLinesMapper* mapper)
    {
      mapper->SetInputArrayToProcess(
        vtkInkSplattingLinesMapper::NORMALS, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Direction");
    });
  TestMessage("chosen radii that are missing", points, { "\"Size\"", "\"Normals\" (3)" },
    [](vtkInkSplattingLinesMapper* mapper)
    {
      mapper->SetInputArrayToProcess(
        vtkInkSplattingLinesMapper::RADIUS, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Size");
    });
  for (double radius : { -1.0, 0.0, NaN, Infinity })
  {
    InkTestPoints::SetRadius(points, radius);
    TestMessage("radii of " + std::to_string(radius), points, { "positive radius", "points" });
  }
  AddArray(points, "Radius", 3, 1.0);
  TestMessage("radii of three components", points, { "\"Radius\"", "3 components", "1" });
}

/// No points: nothing drawn, no message.
TEST(SplattingLinesInput, Empty)
{
  vtkNew<vtkPolyData> empty;
  SplattingLinesScene scene(empty);
  vtkNew<InkTestMessages> messages;
  messages->Observe(scene.Mapper);
  EXPECT_TRUE(InkTestImage(scene.Window).CountDark(255) == 0 && messages->Messages.empty())
    << "nothing for an empty input";
  vtkNew<vtkPoints> none;
  empty->SetPoints(none);
  EXPECT_TRUE(InkTestImage(scene.Window).CountDark(255) == 0 && messages->Messages.empty())
    << "nothing for an input of no points";
}

TEST(SplattingLinesInput, SinglePoint)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(7.0, 8.0, 9.0);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  AddArray(data, "Normals", 3, 1.0);
  for (double radius : { 0.0, 2.0 })
  {
    SplattingLinesScene scene(data);
    scene.Mapper->SetRadius(radius);
    scene.Renderer->SetBackground(0.0, 0.0, 0.0);
    scene.Renderer->ResetCamera();
    const InkTestImage image(scene.Window);
    const int paper = 200 * 200 - image.CountDark(255);
    EXPECT_TRUE(image.Gray(100, 100) == 255 && paper > 2000)
      << "a disc for one point: " << paper << " pixels";
  }
}

/// Points that cannot be drawn do not disturb those that can.
TEST(SplattingLinesInput, PassedOver)
{
  auto good = InkTestPoints::Sphere(1.0, 0.05);
  InkTestPoints::SetRadius(good, 0.06);
  SplattingLinesScene reference(good);
  const InkTestImage expected(reference.Window);

  auto bad = InkTestPoints::Sphere(1.2, 0.3);
  const vtkIdType count = bad->GetNumberOfPoints();
  auto mixed = InkTestPoints::Join(good, bad);
  InkTestPoints::SetRadius(mixed, 0.06);
  vtkDataArray* normals = mixed->GetPointData()->GetArray("Normals");
  vtkDataArray* radii = mixed->GetPointData()->GetArray("Radius");
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType id = good->GetNumberOfPoints() + i;
    switch (i % 7)
    {
      case 0:
        normals->SetTuple3(id, 0.0, 0.0, 0.0);
        break;
      case 1:
        normals->SetTuple3(id, 0.0, NaN, 1.0);
        break;
      case 2:
        mixed->GetPoints()->SetPoint(id, NaN, 0.0, 0.0);
        break;
      case 3:
        mixed->GetPoints()->SetPoint(id, 0.0, Infinity, 0.0);
        break;
      case 4:
        radii->SetTuple1(id, NaN);
        break;
      case 5:
        radii->SetTuple1(id, -1.0);
        break;
      default:
        radii->SetTuple1(id, 0.0);
        break;
    }
  }
  SplattingLinesScene scene(mixed);
  vtkNew<InkTestMessages> messages;
  messages->Observe(scene.Mapper);
  scene.Renderer->GetActiveCamera()->DeepCopy(reference.Renderer->GetActiveCamera());
  const int different = InkTestImage(scene.Window).CountDifferent(expected, 40);
  EXPECT_LT(different, 20) << "the good points' picture, but for " << different << " pixels";
  EXPECT_TRUE(messages->Messages.empty()) << "no message where some points can be drawn";
  const double* bounds = scene.Mapper->GetBounds();
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_LT(std::abs(bounds[i]), 2.0) << "finite bounds, " << bounds[i];
  }
}

/// What vtkGhostType marks as hidden or duplicate is not there: not in the picture, the bounds, or the
/// estimate of the radius; other marks mean nothing.
TEST(SplattingLinesInput, Ghosts)
{
  for (bool radii : { true, false })
  {
    auto good = InkTestPoints::Sphere(1.0, 0.05);
    auto bad = InkTestPoints::Sphere(5.0, 0.05);
    auto mixed = InkTestPoints::Join(good, bad);
    if (radii)
    {
      InkTestPoints::SetRadius(good, 0.06);
      InkTestPoints::SetRadius(mixed, 0.06);
      mixed->GetPointData()->GetArray("Radius")->SetComponent(mixed->GetNumberOfPoints() - 1, 0, 7.0);
    }
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    for (vtkIdType i = 0; i < mixed->GetNumberOfPoints(); ++i)
    {
      constexpr unsigned char marks[2] = { vtkDataSetAttributes::DUPLICATEPOINT,
        vtkDataSetAttributes::HIDDENPOINT };
      ghosts->InsertNextValue(i < good->GetNumberOfPoints() ? 16 : marks[i % 2]);
    }
    mixed->GetPointData()->AddArray(ghosts);
    SplattingLinesScene expected(good);
    SplattingLinesScene scene(mixed);
    const InkTestImage picture(expected.Window);
    EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(picture), 0)
      << "ghosts are not in the picture" << (radii ? "" : " and not in the estimate of the radius");
    double bounds[2][6];
    expected.Mapper->GetBounds(bounds[0]);
    scene.Mapper->GetBounds(bounds[1]);
    EXPECT_TRUE(std::equal(bounds[0], bounds[0] + 6, bounds[1])) << "ghosts are not in the bounds";
    // Shown again, they send the points anew.
    ghosts->Fill(0);
    ghosts->Modified();
    mixed->Modified();
    scene.Renderer->ResetCamera();
    EXPECT_GT(InkTestImage(scene.Window).CountDifferent(picture), 100)
      << "they are there when their marks go";
  }
  auto points = InkTestPoints::Sphere(1.0, 0.2);
  vtkNew<vtkUnsignedCharArray> all;
  all->SetName(vtkDataSetAttributes::GhostArrayName());
  all->SetNumberOfTuples(points->GetNumberOfPoints());
  all->Fill(vtkDataSetAttributes::HIDDENPOINT);
  points->GetPointData()->AddArray(all);
  SplattingLinesScene none(points);
  EXPECT_EQ(InkTestImage(none.Window).Ink(), 0.0) << "nothing drawn of ghosts only";
}

/// Normals of any length and type, and the active normals where there is no array Normals.
TEST(SplattingLinesInput, Normals)
{
  auto points = InkTestPoints::Sphere(1.0, 0.05);
  SplattingLinesScene reference(points);
  const InkTestImage expected(reference.Window);
  vtkDataArray* normals = points->GetPointData()->GetArray("Normals");
  vtkNew<vtkIntArray> integers;
  integers->SetName("gradient");
  integers->SetNumberOfComponents(3);
  integers->SetNumberOfTuples(points->GetNumberOfPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      integers->SetComponent(i, axis, std::round(100000.0 * normals->GetComponent(i, axis)));
    }
  }
  points->GetPointData()->RemoveArray("Normals");
  points->GetPointData()->SetNormals(integers);
  SplattingLinesScene scene(points);
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(expected, 10), 0) << "active integer normals";
}

/// Sums of floating-point numbers depend on their order in the last bits, and so the picture by the least
/// step of a few pixels: points of several processes come in another order than those of one.
TEST(SplattingLinesInput, Order)
{
  auto points = InkTestPoints::Torus(1.0, 0.4, 0.02);
  InkTestPoints::SetRadius(points, 0.03);
  const vtkIdType count = points->GetNumberOfPoints();
  const auto draw = [](vtkPolyData* data)
  {
    SplattingLinesScene scene(data);
    scene.Mapper->SetPhi(100.0);
    return InkTestImage(scene.Window);
  };
  const InkTestImage expected = draw(points);
  EXPECT_GT(expected.CountDark(), 500) << "lines of a torus";
  // Backwards, and its second half first.
  for (const vtkIdType start : { count - 1, count / 2 })
  {
    auto other = vtkSmartPointer<vtkPolyData>::New();
    other->DeepCopy(points);
    for (vtkIdType i = 0; i < count; ++i)
    {
      const vtkIdType from = start == count - 1 ? start - i : (start + i) % count;
      other->GetPoints()->SetPoint(i, points->GetPoint(from));
      other->GetPointData()->SetTuple(i, from, points->GetPointData());
    }
    const InkTestImage found = draw(other);
    EXPECT_EQ(found.CountDifferent(expected, 1), 0)
      << "points in another order: no pixel differs by two steps";
    EXPECT_LE(found.CountDifferent(expected), 4) << "points in another order: hardly a pixel differs";
  }
}
