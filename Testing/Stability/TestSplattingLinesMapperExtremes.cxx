// SPDX-License-Identifier: BSD-3-Clause
// vtkInkSplattingLinesMapper at the ends of what it accepts: data, cameras, windows and all parameters. There
// must be no message, the same picture once more with everything made anew, and the picture that is known:
// equal to another one, or with as much ink as was found right when the picture was checked by eye.
#include "InkTestImage.h"
#include "InkTestMessages.h"
#include "InkTestPoints.h"
#include "InkTestScene.h"
#include "vtkInkSplattingLinesMapper.h"

#include "Core/Hash.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace
{

using Scene = InkTestScene<vtkInkSplattingLinesMapper>;
using Points = vtkSmartPointer<vtkPolyData>;

/// The ink of a picture that must come without a message and twice the same.
double Draw(const std::string& name, Scene& scene)
{
  vtkNew<InkTestMessages> messages;
  messages->Observe(scene.Mapper);
  const InkTestImage first(scene.Window);
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  const InkTestImage second(scene.Window);
  EXPECT_EQ(second.CountDifferent(first), 0) << name << ": the same picture twice";
  EXPECT_TRUE(messages->Messages.empty())
    << name << ": no message, found " << (messages->Messages.empty() ? "" : messages->Messages[0]);
  return first.Ink();
}

/// @param part by how much the ink may differ
void CheckInk(const std::string& name, double ink, double expected, double part = 0.1)
{
  EXPECT_LE(std::abs(ink - expected), part * expected + 0.5)
    << name << ": " << expected << " pixels of ink, found " << ink;
}

/// Everything that can be asked for at once.
void AskForAll(vtkInkSplattingLinesMapper* mapper)
{
  mapper->HiddenLayersOn();
  mapper->SetNumberOfLayers(8);
  mapper->PeelBackFacesOn();
  mapper->SetHardness(0.5);
  mapper->SetSpeckleLength(3.0);
  mapper->ThinningOn();
  mapper->SetLineWidth(5.0);
  for (int layer = 0; layer < 8; ++layer)
  {
    mapper->SetLayerDashLength(layer, 20.0);
  }
  mapper->SetInkColorMode(vtkInkSplattingLinesMapper::TONE);
}

Points FromTuples(const std::vector<std::array<double, 3>>& positions, const std::array<double, 3>& normal)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (const auto& position : positions)
  {
    points->InsertNextPoint(position.data());
    normals->InsertNextTuple(normal.data());
  }
  auto data = Points::New();
  data->SetPoints(points);
  data->GetPointData()->AddArray(normals);
  return data;
}

} // namespace

/// Sets of points that are hardly surfaces: discs; and surfaces of extreme positions and sizes,
/// which look like any.
TEST(SplattingLinesMapperExtremes, Points)
{
  const double tiny = 1e-150;
  const std::array<double, 3> up{ 0.0, 0.0, 1.0 };
  const auto triangle = [](const std::array<double, 3>& normal) {
    return FromTuples({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, normal);
  };
  struct Case
  {
    std::string Name;
    Points Data;
    int Paper; ///< pixels
  };
  const std::vector<Case> discs{
    { "one point", FromTuples({ { 1.0, 2.0, 3.0 } }, up), 156 },
    { "two points", FromTuples({ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } }, up), 248 },
    { "a hundred points at one position",
      FromTuples(std::vector<std::array<double, 3>>(100, { 5.0, 5.0, 5.0 }), up), 156 },
    { "points in a row", FromTuples({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 } }, up), 252 },
    { "points edge-on", triangle({ 1.0, 0.0, 0.0 }), 35 },
    { "normals of 1e-150", triangle({ 0.0, 0.0, tiny }), 269 },
    { "normals of 1e30", triangle({ 0.0, 0.0, 1e30 }), 269 },
  };
  for (const auto& [name, data, expected] : discs)
  {
    for (bool all : { false, true })
    {
      Scene scene(data, 100, 100);
      scene.Renderer->SetBackground(0.0, 0.0, 0.0);
      scene.Renderer->GetActiveCamera()->Zoom(0.2);
      if (all)
      {
        AskForAll(scene.Mapper);
      }
      // Without ink.
      scene.Mapper->SetPhi(0.0);
      const double darkness = Draw(name + (all ? ", all asked for" : ""), scene);
      CheckInk(name + ": paper", 10000.0 - darkness, expected, 0.02);
    }
  }

  for (bool all : { false, true })
  {
    const auto ask = [all](Scene& scene)
    {
      if (all)
      {
        AskForAll(scene.Mapper);
      }
    };
    Scene usual(InkTestPoints::Sphere(1.0, 0.1), 100, 100);
    ask(usual);
    const InkTestImage picture(usual.Window);
    CheckInk("a sphere", picture.Ink(), all ? 95.5 : 423.7);
    for (const auto& [name, scale, position] :
      { std::tuple("spacing 1e-9", 1e-9, 0.0), { "spacing 1e9", 1e9, 0.0 }, { "origin at 1e7", 1.0, 1e7 } })
    {
      Scene scene(
        InkTestPoints::Transform(InkTestPoints::Sphere(1.0, 0.1), scale, { position, -position, position }),
        100, 100);
      ask(scene);
      Draw(name, scene);
      const int different = InkTestImage(scene.Window).CountDifferent(picture, 8);
      EXPECT_LE(different, 2) << name << ": the usual sphere but for " << different << " pixels";
    }
  }
}

/// Some points are spoilt in all ways; the others are drawn as if these were not there.
TEST(SplattingLinesMapperExtremes, Spoilt)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  auto good = InkTestPoints::Sphere(1.0, 0.05);
  InkTestPoints::SetRadius(good, 0.06);
  Scene expected(good, 120, 120);
  const InkTestImage picture(expected.Window);

  auto spoilt = InkTestPoints::Join(good, good);
  InkTestPoints::SetRadius(spoilt, 0.06);
  const vtkIdType half = good->GetNumberOfPoints();
  vtkDataArray* normals = spoilt->GetPointData()->GetArray("Normals");
  vtkDataArray* radii = spoilt->GetPointData()->GetArray("Radius");
  for (vtkIdType i = half; i < 2 * half; ++i)
  {
    const double worst[3] = { nan, infinity, -infinity };
    switch (i % 4)
    {
      case 0:
        spoilt->GetPoints()->SetPoint(i, worst[i % 3], 0.0, 0.0);
        break;
      case 1:
        normals->SetTuple3(i, 0.0, worst[i % 3], 0.0);
        break;
      case 2:
        normals->SetTuple3(i, 0.0, 0.0, 0.0);
        break;
      default:
        radii->SetTuple1(i, i % 8 < 4 ? worst[i % 3] : -1.0);
        break;
    }
  }
  Scene scene(spoilt, 120, 120);
  scene.Renderer->SetActiveCamera(expected.Renderer->GetActiveCamera());
  Draw("spoilt points", scene);
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(picture, 1), 0) << "spoilt points are not there";
}

/// Radii of all sizes in one set of points: no gaps, and no light from afar.
TEST(SplattingLinesMapperExtremes, Radii)
{
  auto points = InkTestPoints::Sphere(1.0, 0.05);
  InkTestPoints::SetRadius(points, 0.06);
  vtkDataArray* radii = points->GetPointData()->GetArray("Radius");
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    radii->SetTuple1(
      i, 0.06 * std::pow(10.0, 0.5 * ink::unitDouble(ink::hash(3, static_cast<std::uint64_t>(i)))));
  }
  Scene scene(points, 120, 120);
  const double ink = Draw("radii of 1 to 3", scene);
  CheckInk("a contour with uneven radii", ink, 352.6);
  // Points without an extent, and discs so large that the nearest ones end before the camera.
  for (const auto& [radius, expected] :
    { std::pair(1e-9, 261.3), { 1e-3, 260.9 }, { 10.0, 14397.2 }, { 1e6, 14400.0 } })
  {
    InkTestPoints::SetRadius(points, radius);
    scene.Mapper->SetInputData(points);
    const std::string name = "radius " + std::to_string(radius);
    CheckInk(name, Draw(name, scene), expected);
  }
}

/// Each parameter at both its ends, with the others as they are and with everything asked for.
TEST(SplattingLinesMapperExtremes, Parameters)
{
  struct Case
  {
    const char* Name;
    std::function<void(vtkInkSplattingLinesMapper*, double)> Set;
    struct End
    {
      double Value;
      double Ink;      ///< with the others as they are
      double InkOfAll; ///< with everything asked for
    };
    std::vector<End> Ends;
  };
  using Mapper = vtkInkSplattingLinesMapper;
  const std::vector<Case> cases{
    { "lambda", [](Mapper* m, double v) { m->SetLambda(v); },
      { { 0.1, 340.2, 131.0 }, { 20.0, 621.1, 90.8 } } },
    { "tau", [](Mapper* m, double v) { m->SetTau(v); }, { { 0.8, 226.4, 125.1 }, { 1.2, 1536.4, 45.2 } } },
    { "phi", [](Mapper* m, double v) { m->SetPhi(v); }, { { 0.0, 0.0, 0.0 }, { 500.0, 360.4, 127.9 } } },
    { "sigma", [](Mapper* m, double v) { m->SetSigma(v); },
      { { 0.05, 284.4, 137.2 }, { 2.0, 344.2, 123.0 } } },
    { "minimum radius", [](Mapper* m, double v) { m->SetMinimumRadius(v); },
      { { 0.0, 346.0, 128.7 }, { 50.0, 523.2, 148.0 } } },
    { "layers", [](Mapper* m, double v) { m->SetNumberOfLayers(static_cast<int>(v)); },
      { { 1.0, 346.0, 101.5 }, { 8.0, 346.0, 128.7 } } },
    { "hardness", [](Mapper* m, double v) { m->SetHardness(v); },
      { { 0.0, 346.0, 128.0 }, { 1.0, 347.7, 128.7 } } },
    { "speckle length", [](Mapper* m, double v) { m->SetSpeckleLength(v); },
      { { 0.0, 346.0, 128.7 }, { 1000.0, 0.0, 0.0 } } },
    { "line width", [](Mapper* m, double v) { m->SetLineWidth(v); },
      { { -20.0, 175.9, 38.6 }, { 20.0, 602.6, 244.4 } } },
    { "dash length", [](Mapper* m, double v) { m->SetLayerDashLength(0, v); },
      { { 1e-6, 346.0, 227.7 }, { 100.0, 173.0, 134.1 } } },
    { "coarsest texel", [](Mapper* m, double v) { m->SetMaximumDownsampling(static_cast<int>(v)); },
      { { 1.0, 346.0, 128.7 }, { 4.0, 346.0, 128.7 } } },
    { "half floats", [](Mapper* m, double v) { m->SetHalfFloats(v > 0.0); },
      { { 0.0, 346.0, 128.7 }, { 1.0, 345.6, 128.9 } } },
    { "point fraction", [](Mapper* m, double v) { m->SetPointFraction(v); },
      { { 0.01, 599.6, 218.1 }, { 1.0, 346.0, 128.7 } } },
    { "as published", [](Mapper* m, double v) { m->SetAsPublished(v > 0.0); },
      { { 0.0, 346.0, 128.7 }, { 1.0, 246.6, 117.6 } } },
    { "paper", [](Mapper* m, double v) { m->SetPaperVisibility(v > 0.0); },
      { { 0.0, 346.0, 128.8 }, { 1.0, 346.0, 128.7 } } },
  };
  auto points = InkTestPoints::Join(InkTestPoints::Torus(1.0, 0.4, 0.05), InkTestPoints::Sphere(0.3, 0.05));
  for (const Case& one : cases)
  {
    for (const auto& [value, inkOfOne, inkOfAll] : one.Ends)
    {
      for (bool all : { false, true })
      {
        Scene scene(points, 101, 67);
        if (all)
        {
          AskForAll(scene.Mapper);
        }
        one.Set(scene.Mapper, value);
        const std::string name =
          one.Name + (' ' + std::to_string(value)) + (all ? ", all else asked for" : "");
        CheckInk(name, Draw(name, scene), all ? inkOfAll : inkOfOne);
      }
    }
  }
}

/// Cameras within the object, on it, far away and looking elsewhere; parallel and perspective. With parallel
/// rays the distance does not count, but where the camera cuts the object.
TEST(SplattingLinesMapperExtremes, Views)
{
  auto points = InkTestPoints::Sphere(1.0, 0.05);
  struct View
  {
    double Distance;
    double Perspective; ///< its ink; from within, a sphere is even
    double Parallel;
    double ParallelAway; ///< the outline of the part behind the camera, which cuts it
  };
  for (const View& view : { View{ 0.0, 0.0, 90.6, 0.0 }, { 0.5, 0.0, 109.1, 56.0 },
         { 0.999, 0.0, 109.1, 0.8 }, { 1.001, 0.0, 109.1, 0.0 }, { 3.0, 31.4, 109.1, 0.0 },
         { 1e3, 0.0, 109.1, 0.0 }, { 1e7, 0.0, 94.9, 0.0 } })
  {
    for (bool parallel : { false, true })
    {
      for (bool away : { false, true })
      {
        Scene scene(points, 90, 90);
        AskForAll(scene.Mapper);
        vtkCamera* camera = scene.Renderer->GetActiveCamera();
        camera->SetParallelProjection(parallel);
        camera->SetPosition(0.0, 0.0, view.Distance);
        camera->SetFocalPoint(0.0, 0.0, away ? 2.0 * view.Distance + 1.0 : -1.0);
        scene.Renderer->ResetCameraClippingRange();
        const std::string name = std::string(parallel ? "a parallel" : "a perspective") + " camera at " +
          std::to_string(view.Distance) + (away ? " that looks away" : "");
        const bool beside = away && view.Distance > 0.0;
        CheckInk(name, Draw(name, scene),
          parallel ? (beside ? view.ParallelAway : view.Parallel) : (beside ? 0.0 : view.Perspective));
      }
    }
  }
}

/// Windows of all shapes; what is drawn fits.
TEST(SplattingLinesMapperExtremes, Windows)
{
  auto points = InkTestPoints::Sphere(1.0, 0.05);
  struct Shape
  {
    int Width;
    int Height;
    double Ink;
    double InkOfAll;
  };
  for (const Shape& shape : { Shape{ 1, 1, 0.0, 0.0 }, { 1, 200, 2.0, 0.0 }, { 200, 1, 2.0, 0.0 },
         { 3, 2, 4.7, 1.9 }, { 33, 257, 87.5, 68.4 }, { 900, 20, 44.2, 13.2 } })
  {
    for (bool all : { false, true })
    {
      Scene scene(points, shape.Width, shape.Height);
      if (all)
      {
        AskForAll(scene.Mapper);
      }
      const std::string name = std::to_string(shape.Width) + " x " + std::to_string(shape.Height) +
        " pixels" + (all ? ", all asked for" : "");
      CheckInk(name, Draw(name, scene), all ? shape.InkOfAll : shape.Ink);
    }
  }
}

/// Flattened, mirrored and sheared actors.
TEST(SplattingLinesMapperExtremes, Matrices)
{
  struct Stretch
  {
    std::array<double, 3> Scale;
    double Ink;
  };
  for (const auto& [scale, expected] : { Stretch{ { 1.0, 1.0, 1e-3 }, 214.1 },
         { { 1.0, 1000.0, 1.0 }, 175.2 }, { { -1.0, 1.0, 1.0 }, 235.3 }, { { 1e-6, 1e-6, 1e-6 }, 235.3 } })
  {
    Scene scene(InkTestPoints::Sphere(1.0, 0.05), 90, 90);
    scene.Actor->SetScale(scale[0], scale[1], scale[2]);
    scene.Renderer->ResetCamera();
    std::ostringstream name;
    name << "scale " << scale[0] << ' ' << scale[1] << ' ' << scale[2];
    CheckInk(name.str(), Draw(name.str(), scene), expected);
  }
  Scene mirrored(InkTestPoints::Sphere(1.0, 0.02), 120, 120);
  const double ink = Draw("a sphere", mirrored);
  mirrored.Actor->SetScale(-1.0, 1.0, 1.0);
  const double other = Draw("its mirror image", mirrored);
  CheckInk("a mirrored sphere has the same lines", other, ink, 0.001);
}
