// SPDX-License-Identifier: BSD-3-Clause
// vtkInkSplattingLinesMapper at the ends of what it accepts: data, cameras, windows and all parameters. Where
// the picture is known, it is checked; everywhere there must be no message, and the same picture twice.
#include "InkTestChecks.h"
#include "InkTestImage.h"
#include "InkTestPoints.h"
#include "InkTestScene.h"
#include "vtkInkSplattingLinesMapper.h"

#include "Sampling/Hash.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{

using Scene = InkTestScene<vtkInkSplattingLinesMapper>;
using Points = vtkSmartPointer<vtkPolyData>;

/// The ink of a picture that must come without a message and twice the same.
double Draw(InkTestChecks& check, const std::string& name, Scene& scene)
{
  vtkNew<InkTestMessages> messages;
  messages->Observe(scene.Mapper);
  const InkTestImage first(scene.Window);
  scene.Mapper->Modified();
  scene.Renderer->GetActiveCamera()->Modified();
  const InkTestImage second(scene.Window);
  check(second.CountDifferent(first) == 0, name, ": the same picture twice");
  check(messages->Messages.empty(), name, ": no message, found ",
    messages->Messages.empty() ? "" : messages->Messages[0]);
  return first.Ink();
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

Points FromTuples(const std::vector<std::array<double, 3>>& places, const std::array<double, 3>& normal)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (const auto& place : places)
  {
    points->InsertNextPoint(place.data());
    normals->InsertNextTuple(normal.data());
  }
  auto data = Points::New();
  data->SetPoints(points);
  data->GetPointData()->AddArray(normals);
  return data;
}

/// Sets of points that are hardly surfaces.
void TestPoints(InkTestChecks& check)
{
  const double tiny = 1e-150;
  const std::array<double, 3> up{ 0.0, 0.0, 1.0 };
  const std::vector<std::pair<std::string, Points>> cases{
    { "one point", FromTuples({ { 1.0, 2.0, 3.0 } }, up) },
    { "two points", FromTuples({ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } }, up) },
    { "a hundred points in one place",
      FromTuples(std::vector<std::array<double, 3>>(100, { 5.0, 5.0, 5.0 }), up) },
    { "points in a row", FromTuples({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 } }, up) },
    { "points edge-on", FromTuples({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { 1.0, 0.0, 0.0 }) },
    { "normals of 1e-150",
      FromTuples({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { 0.0, 0.0, tiny }) },
    { "normals of 1e30", FromTuples({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { 0.0, 0.0, 1e30 }) },
    { "spacing 1e-9", InkTestPoints::Transform(InkTestPoints::Sphere(1.0, 0.1), 1e-9, {}) },
    { "spacing 1e9", InkTestPoints::Transform(InkTestPoints::Sphere(1.0, 0.1), 1e9, {}) },
    { "origin at 1e7", InkTestPoints::Transform(InkTestPoints::Sphere(1.0, 0.1), 1.0, { 1e7, -1e7, 1e7 }) },
  };
  for (const auto& [name, points] : cases)
  {
    for (bool all : { false, true })
    {
      Scene scene(points, 100, 100);
      if (all)
      {
        AskForAll(scene.Mapper);
      }
      const double ink = Draw(check, name + (all ? ", all asked for" : ""), scene);
      check(std::isfinite(ink), name, ": a picture");
    }
  }
}

/// Some points are spoilt in all ways; the others are drawn as if these were not there.
void TestSpoilt(InkTestChecks& check)
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
  Draw(check, "spoilt points", scene);
  check(InkTestImage(scene.Window).CountDifferent(picture, 1) == 0, "spoilt points are not there");
}

/// Radii of all sizes in one set of points: no gaps, and no light from afar.
void TestRadii(InkTestChecks& check)
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
  const double ink = Draw(check, "radii of 1 to 3", scene);
  check(ink > 100.0, "a contour with uneven radii: ", ink);
  for (double radius : { 1e-9, 1e-3, 10.0, 1e6 })
  {
    InkTestPoints::SetRadius(points, radius);
    scene.Mapper->SetInputData(points);
    Draw(check, "radius " + std::to_string(radius), scene);
  }
}

/// Each parameter at both its ends, with the others as they are and with everything asked for.
void TestParameters(InkTestChecks& check)
{
  struct Case
  {
    const char* Name;
    std::function<void(vtkInkSplattingLinesMapper*, double)> Set;
    std::vector<double> Values;
  };
  using Mapper = vtkInkSplattingLinesMapper;
  const std::vector<Case> cases{
    { "lambda", [](Mapper* m, double v) { m->SetLambda(v); }, { 0.1, 20.0 } },
    { "tau", [](Mapper* m, double v) { m->SetTau(v); }, { 0.8, 1.2 } },
    { "phi", [](Mapper* m, double v) { m->SetPhi(v); }, { 0.0, 500.0 } },
    { "sigma", [](Mapper* m, double v) { m->SetSigma(v); }, { 0.05, 2.0 } },
    { "minimum radius", [](Mapper* m, double v) { m->SetMinimumRadius(v); }, { 0.0, 50.0 } },
    { "layers", [](Mapper* m, double v) { m->SetNumberOfLayers(static_cast<int>(v)); }, { 1.0, 8.0 } },
    { "hardness", [](Mapper* m, double v) { m->SetHardness(v); }, { 0.0, 1.0 } },
    { "speckle length", [](Mapper* m, double v) { m->SetSpeckleLength(v); }, { 0.0, 1000.0 } },
    { "line width", [](Mapper* m, double v) { m->SetLineWidth(v); }, { -20.0, 20.0 } },
    { "dash length", [](Mapper* m, double v) { m->SetLayerDashLength(0, v); }, { 1e-6, 100.0 } },
    { "coarsest texel", [](Mapper* m, double v) { m->SetCoarsestTexel(static_cast<int>(v)); }, { 1.0, 4.0 } },
    { "half floats", [](Mapper* m, double v) { m->SetHalfFloats(v > 0.0); }, { 0.0, 1.0 } },
    { "point fraction", [](Mapper* m, double v) { m->SetPointFraction(v); }, { 0.01, 1.0 } },
    { "as published", [](Mapper* m, double v) { m->SetAsPublished(v > 0.0); }, { 0.0, 1.0 } },
    { "paper", [](Mapper* m, double v) { m->SetPaperVisibility(v > 0.0); }, { 0.0, 1.0 } },
  };
  auto points = InkTestPoints::Join(InkTestPoints::Torus(1.0, 0.4, 0.05), InkTestPoints::Sphere(0.3, 0.05));
  for (const Case& one : cases)
  {
    for (double value : one.Values)
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
        Draw(check, name, scene);
      }
    }
  }
}

/// Cameras within the object, on it, far away and looking elsewhere; parallel and perspective.
void TestViews(InkTestChecks& check)
{
  auto points = InkTestPoints::Sphere(1.0, 0.05);
  for (bool parallel : { false, true })
  {
    for (double distance : { 0.0, 0.5, 0.999, 1.001, 3.0, 1e3, 1e7 })
    {
      for (bool away : { false, true })
      {
        Scene scene(points, 90, 90);
        AskForAll(scene.Mapper);
        vtkCamera* camera = scene.Renderer->GetActiveCamera();
        camera->SetParallelProjection(parallel);
        camera->SetPosition(0.0, 0.0, distance);
        camera->SetFocalPoint(0.0, 0.0, away ? 2.0 * distance + 1.0 : -1.0);
        scene.Renderer->ResetCameraClippingRange();
        const double ink = Draw(check, "a camera at " + std::to_string(distance), scene);
        check(!away || distance < 3.0 || ink == 0.0, "nothing where the camera looks away from it");
      }
    }
  }
}

/// Windows of all shapes; what is drawn fits.
void TestWindows(InkTestChecks& check)
{
  auto points = InkTestPoints::Sphere(1.0, 0.05);
  for (const auto& [width, height] :
    { std::pair(1, 1), { 1, 200 }, { 200, 1 }, { 3, 2 }, { 33, 257 }, { 900, 20 } })
  {
    for (bool all : { false, true })
    {
      Scene scene(points, width, height);
      if (all)
      {
        AskForAll(scene.Mapper);
      }
      Draw(check, std::to_string(width) + " x " + std::to_string(height) + " pixels", scene);
    }
  }
}

/// Flattened, mirrored and sheared actors.
void TestMatrices(InkTestChecks& check)
{
  for (const std::array<double, 3>& scale :
    { std::array{ 1.0, 1.0, 1e-3 }, { 1.0, 1000.0, 1.0 }, { -1.0, 1.0, 1.0 }, { 1e-6, 1e-6, 1e-6 } })
  {
    Scene scene(InkTestPoints::Sphere(1.0, 0.05), 90, 90);
    scene.Actor->SetScale(scale[0], scale[1], scale[2]);
    scene.Renderer->ResetCamera();
    Draw(check, "scale " + std::to_string(scale[2]), scene);
  }
  Scene mirrored(InkTestPoints::Sphere(1.0, 0.02), 120, 120);
  const double ink = Draw(check, "a sphere", mirrored);
  mirrored.Actor->SetScale(-1.0, 1.0, 1.0);
  const double other = Draw(check, "its mirror image", mirrored);
  check(std::abs(ink - other) < 0.05 * ink, "a mirrored sphere has the same lines: ", other, " of ", ink);
}

} // namespace

int TestSplattingLinesMapperExtremes(int, char*[])
{
  InkTestChecks check;
  TestPoints(check);
  TestSpoilt(check);
  TestRadii(check);
  TestParameters(check);
  TestViews(check);
  TestWindows(check);
  TestMatrices(check);
  return check.Result();
}
