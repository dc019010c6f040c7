// SPDX-License-Identifier: BSD-3-Clause
// vtkInkStippleMapper and vtkInkStippleControls at the ends of what there is, from odd data to odd views: the
// right picture, or an empty one with one clear message; with places in either precision.

#include "InkTestChecks.h"
#include "InkTestImage.h"
#include "InkTestMesh.h"
#include "InkTestStipples.h"
#include "StippleScene.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInkStippleControls.h"
#include "vtkInkStippleGenerator.h"
#include "vtkIntArray.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkStringArray.h"
#include "vtkStringOutputWindow.h"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

using Data = vtkSmartPointer<vtkPolyData>;
using Change = std::function<void(StippleScene&)>;

/// The ink of the data's picture in a window of 120 x 120 pixels. Places in either precision give the same.
/// @param words that the one message has to contain; empty: there must be none
double FindInk(
  InkTestChecks& check, const std::string& name, vtkPolyData* data,
  const Change& change = [](StippleScene&) {}, const std::vector<std::string>& words = {})
{
  StippleScene scene(data, 120, 120);
  vtkNew<InkTestMessages> messages;
  messages->Observe(scene.Mapper);
  change(scene);
  const InkTestImage image(scene.Window);
  // Neither again by another picture nor by a question is anything said twice.
  vtkNew<vtkFloatArray> marks;
  const bool found = scene.Mapper->FindMarks(scene.Renderer, scene.Actor, marks);
  check(found || image.Ink() == 0.0 || scene.Renderer->GetSize()[0] <= 0, name, ": marks where there is ink");
  messages->Expect(check, name, words);
  if (words.empty())
  {
    for (vtkIdType i = 0; i < marks->GetNumberOfTuples(); ++i)
    {
      const double* mark = marks->GetTuple(i);
      if (!check(mark[0] >= 0.0 && mark[1] >= 0.0 && mark[1] <= 1.0 && mark[2] >= 0.0 &&
              std::isfinite(mark[0]) && std::isfinite(mark[2]),
            name, ": marks in range, found T ", mark[0], ", opacity ", mark[1], ", diameter ", mark[2]))
      {
        break;
      }
    }
  }
  scene.Mapper->SetPositionPrecision(vtkInkStippleMapper::QUANTIZED);
  const double ink = image.Ink();
  const double packed = InkTestImage(scene.Window).Ink();
  check(std::abs(packed - ink) <= 0.01 * ink + 0.5, name, ": the same ink of quantized places, ", ink,
    ", found ", packed);
  return ink;
}

void ExpectInk(
  InkTestChecks& check, const std::string& name, vtkPolyData* data, double least, double most,
  const Change& change = [](StippleScene&) {})
{
  const double ink = FindInk(check, name, data, change);
  check(ink >= least && ink <= most, name, ": ink of ", least, " to ", most, ", found ", ink);
}

/// Ink as it was found when the picture was looked at, to a quarter; none is exactly none.
void ExpectAbout(
  InkTestChecks& check, const std::string& name, vtkPolyData* data, double ink,
  const Change& change = [](StippleScene&) {})
{
  ExpectInk(check, name, data, 0.8 * ink, 1.25 * ink, change);
}

/// Where a pixel is a part of it, in which window's brightness has 256 steps.
void ExpectPale(
  InkTestChecks& check, const std::string& name, vtkPolyData* data, double ink,
  const Change& change = [](StippleScene&) {})
{
  constexpr double step = 1.0 / 255.0;
  ExpectInk(check, name, data, 0.5 * ink - step, 2.0 * ink + step, change);
}

void ExpectMessage(InkTestChecks& check, const std::string& name, vtkPolyData* data, const std::string& word)
{
  check(FindInk(check, name, data, [](StippleScene&) {}, { word }) == 0.0, name, ": nothing drawn");
}

/// What the generator makes of a ball that fills most of n voxels a side.
Data StippleBall(int type, const std::array<int, 3>& n, const std::function<void(vtkImageData*)>& change)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(n.data());
  image->AllocateScalars(type, 1);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  vtkSmartPointer<vtkDataArray> range = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
  const bool integer = type != VTK_FLOAT && type != VTK_DOUBLE;
  // Doubles just within a 64-bit integer's range.
  const double low = integer ? range->GetDataTypeMin() * (1.0 - 1e-15) : 0.0;
  const double high = integer ? range->GetDataTypeMax() * (1.0 - 1e-15) : 1.0;
  vtkIdType id = 0;
  for (int k = 0; k < n[2]; ++k)
  {
    for (int j = 0; j < n[1]; ++j)
    {
      for (int i = 0; i < n[0]; ++i)
      {
        const auto place = [](int index, int count)
        { return count > 1 ? (2.0 * index + 1.0) / count - 1.0 : 0.0; };
        const double r = std::hypot(place(i, n[0]), place(j, n[1]), place(k, n[2]));
        const double share = std::clamp(0.5 + 6.0 * (0.75 - r), 0.0, 1.0);
        scalars->SetComponent(id++, 0, (1.0 - share) * low + share * high);
      }
    }
  }
  change(image);
  vtkNew<vtkInkStippleGenerator> generator;
  generator->SetInputData(image);
  generator->SetGradientPercentile(80.0);
  generator->Update();
  return generator->GetOutput();
}

Data StippleBall()
{
  return StippleBall(VTK_FLOAT, { 24, 24, 24 }, [](vtkImageData*) {});
}

void TestPlaces(InkTestChecks& check)
{
  const double usual = FindInk(check, "ball", StippleBall());
  check(usual > 350.0 && usual < 500.0, "ink of a ball, found ", usual);
  const auto expect =
    [&](const std::string& name, const std::function<void(vtkImageData*)>& change, const Change& view)
  {
    const Data data = StippleBall(VTK_FLOAT, { 24, 24, 24 }, change);
    ExpectInk(check, name, data, 0.95 * usual, 1.05 * usual, view);
  };
  const Change front = [](StippleScene&) {};
  const Change side = [](StippleScene& scene)
  {
    scene.Renderer->GetActiveCamera()->SetPosition(1.0, 0.0, 0.0);
    scene.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
    scene.Renderer->ResetCamera();
  };
  for (const double size : { 1e-9, 1e9 })
  {
    const auto scale = [&](vtkImageData* image) { image->SetSpacing(size, size, size); };
    expect("spacing " + std::to_string(size), scale, front);
    expect("spacing " + std::to_string(size) + " from the side", scale, side);
  }
  const auto far = [](vtkImageData* image)
  {
    image->SetOrigin(1e7, -1e7, 1e7);
    image->SetSpacing(0.01, 0.01, 0.01);
  };
  expect("far away", far, front);
  const auto turned = [](vtkImageData* image)
  { image->SetDirectionMatrix(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0); };
  expect("a turned image", turned, front);
  const auto mirrored = [](vtkImageData* image)
  { image->SetDirectionMatrix(-1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0); };
  expect("a mirrored image", mirrored, front);

  // A needle as thin as a pixel, seen from the side or along it.
  for (const int axis : { 0, 1, 2 })
  {
    const auto stretch = [&](vtkImageData* image)
    {
      double spacing[3] = { 1.0, 1.0, 1.0 };
      spacing[axis] = 1000.0;
      image->SetSpacing(spacing);
    };
    const Data data = StippleBall(VTK_FLOAT, { 24, 24, 24 }, stretch);
    const std::string name = "spacing of 1000 along " + std::to_string(axis);
    // A thin line, whose pixels are too pale to show until there are many stipples.
    const Change dark[] = { [](StippleScene& scene) { scene.Mapper->SetPixelsPerStipple(0.1); },
      [&](StippleScene& scene)
      {
        side(scene);
        scene.Mapper->SetPixelsPerStipple(0.1);
      } };
    // Seen along it, it is less than a pixel.
    ExpectPale(check, name, data, axis == 2 ? 0.031 : 3.5, dark[0]);
    ExpectPale(check, name + " from the side", data, axis == 0 ? 0.031 : 3.5, dark[1]);
  }
}

void TestValues(InkTestChecks& check)
{
  const double usual = FindInk(check, "ball", StippleBall());
  for (const int type : { VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT,
         VTK_UNSIGNED_INT, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG, VTK_DOUBLE })
  {
    const Data data = StippleBall(type, { 24, 24, 24 }, [](vtkImageData*) {});
    ExpectInk(check, std::string("the whole range of ") + vtkImageScalarTypeNameMacro(type), data,
      0.97 * usual, 1.03 * usual);
  }
  const auto spoil = [](vtkImageData* image)
  {
    for (vtkIdType n = 0; n < image->GetNumberOfPoints(); n += 17)
    {
      image->GetPointData()->GetScalars()->SetComponent(n, 0, n % 3 ? NaN : Infinity);
    }
  };
  ExpectInk(check, "holes", StippleBall(VTK_FLOAT, { 24, 24, 24 }, spoil), 0.85 * usual, usual);
}

void TestShapes(InkTestChecks& check)
{
  const auto nothing = [](vtkImageData*) {};
  const Data one = StippleBall(VTK_FLOAT, { 1, 1, 1 }, nothing);
  ExpectInk(check, "one voxel", one, 0.0, 0.0);
  const auto even = [](vtkImageData* image) { image->GetPointData()->GetScalars()->Fill(7.0); };
  ExpectInk(check, "a constant", StippleBall(VTK_FLOAT, { 12, 12, 12 }, even), 0.0, 0.0);
  ExpectInk(check, "no cells", vtkSmartPointer<vtkPolyData>::New(), 0.0, 0.0);
  const Data flat = StippleBall(VTK_FLOAT, { 40, 40, 1 }, nothing);
  // Normals lie in the plane and away from an eye before its middle: not lit.
  const auto unlit = [](StippleScene& scene) { scene.Mapper->LightingOff(); };
  ExpectAbout(check, "one voxel thick", flat, 100.0, unlit);
  // All normals are seen edge-on; without a view of its plane it is a line.
  const auto edge = [](StippleScene& scene)
  {
    scene.Renderer->GetActiveCamera()->SetPosition(0.0, -300.0, 0.0);
    scene.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
    scene.Renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
    scene.Renderer->ResetCamera();
  };
  ExpectAbout(check, "one voxel thick, from the edge", flat, 33.0, edge);
  const Data row = StippleBall(VTK_FLOAT, { 60, 1, 1 }, nothing);
  ExpectAbout(check, "a row of voxels", row, 3.7, unlit);

  const auto close = [](StippleScene& scene)
  {
    scene.AllOff();
    scene.Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, 5.0);
    scene.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
    scene.Renderer->ResetCameraClippingRange(-1, 1, -1, 1, -1, 1);
  };
  ExpectAbout(check, "one stipple", InkTestStipples::PlaneSurface(1.0, 1, 1), 1575.0, close);
  ExpectAbout(check, "one element", InkTestStipples::PlaneSurface(1.0, 1, 64), 1460.0, close);

  // Half of the elements without stipples: half of the plane.
  const Data plane = InkTestStipples::PlaneSurface(2.0, 10, 12);
  const double whole = FindInk(check, "plane", plane, [](StippleScene& scene) { scene.AllOff(); });
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkPoints> points;
  for (vtkIdType e = 0; e < plane->GetNumberOfCells(); ++e)
  {
    cells->InsertNextCell(e % 10 < 5 ? 12 : 0);
    for (vtkIdType i = 12 * e; e % 10 < 5 && i < 12 * (e + 1); ++i)
    {
      cells->InsertCellPoint(points->InsertNextPoint(plane->GetPoint(i)));
    }
  }
  Data half = vtkSmartPointer<vtkPolyData>::New();
  half->DeepCopy(plane);
  half->SetPoints(points);
  half->SetVerts(cells);
  const auto same = [](StippleScene& scene)
  {
    scene.AllOff();
    scene.Renderer->ResetCamera(-1.0, 1.0, -1.0, 1.0, 0.0, 0.0);
  };
  ExpectInk(check, "elements without stipples", half, 0.45 * whole, 0.55 * whole, same);
}

/// Meshes through the generator: degenerate, non-manifold, of all sizes.
void TestMeshes(InkTestChecks& check)
{
  for (const double scale : { 1e-9, 1.0, 1e9 })
  {
    const vtkSmartPointer<vtkPolyData> mesh = InkTestOddMesh(scale);
    vtkNew<vtkInkStippleGenerator> generator;
    generator->SetInputData(mesh);
    generator->SetNumberOfSurfaceStipples(4000);
    generator->Update();
    const auto connect = [&](StippleScene& scene)
    {
      // Hidden by the mesh as well.
      scene.Mapper->SetInputConnection(generator->GetOutputPort());
      scene.Mapper->LightingOff();
    };
    ExpectAbout(check, "a mesh of size " + std::to_string(scale), generator->GetOutput(), 1860.0, connect);
  }
}

/// Values, positions and normals that are not finite or zero are passed over; where nothing is left, or
/// arrays do not fit, one message says so.
void TestSpoilt(InkTestChecks& check)
{
  const auto copy = [](vtkPolyData* data)
  {
    Data spoilt = vtkSmartPointer<vtkPolyData>::New();
    spoilt->DeepCopy(data);
    return spoilt;
  };
  const Data voxels = InkTestStipples::SphereVoxels(1.0, 0.15, 6);
  const double usual = FindInk(check, "voxels", voxels);
  const char* const nothingLeft = "None of the";
  for (const double bad : { NaN, Infinity })
  {
    for (const char* name : { "Normals", "GradientMagnitude", "Value" })
    {
      const std::string what = std::string(name) + " of " + std::to_string(bad);
      const Data some = copy(voxels);
      vtkDataArray* array = some->GetCellData()->GetArray(name);
      for (vtkIdType e = 0; e < array->GetNumberOfTuples(); e += 4)
      {
        array->SetComponent(e, 0, bad);
      }
      ExpectInk(check, "some " + what, some, 0.6 * usual, 0.9 * usual);
      array->Fill(bad);
      ExpectMessage(check, "all " + what, some, nothingLeft);
    }
    const Data some = copy(voxels);
    for (vtkIdType i = 0; i < some->GetNumberOfPoints(); i += 4)
    {
      double p[3];
      some->GetPoint(i, p);
      p[i % 3] = bad;
      some->GetPoints()->SetPoint(i, p);
    }
    // Among them the first of every second list.
    ExpectInk(check, "some positions of " + std::to_string(bad), some, 0.4 * usual, 0.9 * usual);
    for (vtkIdType i = 0; i < some->GetNumberOfPoints(); ++i)
    {
      some->GetPoints()->SetPoint(i, bad, bad, bad);
    }
    ExpectMessage(check, "all positions of " + std::to_string(bad), some, nothingLeft);
  }
  const Data flat = copy(voxels);
  vtkDataArray* normals = flat->GetCellData()->GetArray("Normals");
  for (vtkIdType e = 0; e < normals->GetNumberOfTuples(); e += 2)
  {
    normals->SetTuple3(e, 0.0, 0.0, 0.0);
  }
  ExpectInk(check, "some normals of length 0", flat, 0.3 * usual, 0.8 * usual);
  normals->Fill(0.0);
  ExpectMessage(check, "all normals of length 0", flat, nothingLeft);

  // Normals of any other length count as their direction, values beyond 0 to 1 as its ends.
  for (const double length : { 1e-30, 1e30 })
  {
    const Data other = copy(voxels);
    vtkDataArray* array = other->GetCellData()->GetArray("Normals");
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        array->SetComponent(i, axis, length * array->GetComponent(i, axis));
      }
    }
    ExpectInk(check, "normals of length " + std::to_string(length), other, 0.999 * usual, 1.001 * usual);
  }
  const Data beyond = copy(voxels);
  beyond->GetCellData()->GetArray("Value")->Fill(-3.0);
  ExpectInk(check, "values below 0", beyond, 0.0, 0.0);
  beyond->GetCellData()->GetArray("Value")->Fill(1e30);
  beyond->GetCellData()->GetArray("GradientMagnitude")->Fill(1e30);
  ExpectAbout(check, "values above 1", beyond, 3.0 * usual);

  const auto replace = [&](const char* name, const vtkSmartPointer<vtkAbstractArray>& array)
  {
    const Data spoilt = copy(voxels);
    spoilt->GetCellData()->RemoveArray(name);
    if (array)
    {
      array->SetName(name);
      spoilt->GetCellData()->AddArray(array);
    }
    return spoilt;
  };
  for (const char* name : { "Normals", "GradientMagnitude", "Value" })
  {
    const std::string expected = std::string("\"") + name + "\" with";
    auto text = vtkSmartPointer<vtkStringArray>::New();
    text->SetNumberOfValues(voxels->GetNumberOfCells());
    auto wide = vtkSmartPointer<vtkFloatArray>::New();
    wide->SetNumberOfComponents(2);
    wide->SetNumberOfTuples(voxels->GetNumberOfCells());
    wide->Fill(0.5);
    auto few = vtkSmartPointer<vtkFloatArray>::New();
    few->SetNumberOfComponents(std::string(name) == "Normals" ? 3 : 1);
    few->SetNumberOfTuples(3);
    few->Fill(0.5);
    // A volume is known by its gradients; without them and without ElementKind it would be a surface.
    ExpectMessage(check, std::string("no ") + name, replace(name, nullptr), expected);
    ExpectMessage(check, std::string("text as ") + name, replace(name, text), expected);
    ExpectMessage(check, std::string("pairs as ") + name, replace(name, wide), expected);
    ExpectMessage(check, std::string("too few ") + name, replace(name, few), expected);
  }
  auto integers = vtkSmartPointer<vtkIntArray>::New();
  integers->SetNumberOfComponents(3);
  for (vtkIdType e = 0; e < voxels->GetNumberOfCells(); ++e)
  {
    double n[3];
    voxels->GetCellData()->GetArray("Normals")->GetTuple(e, n);
    integers->InsertNextTuple3(
      std::round(1000.0 * n[0]), std::round(1000.0 * n[1]), std::round(1000.0 * n[2]));
  }
  ExpectInk(check, "normals in integers", replace("Normals", integers), 0.99 * usual, 1.01 * usual);

  const auto field = [&](const char* name, double value)
  {
    const Data spoilt = copy(voxels);
    spoilt->GetFieldData()->GetArray(name)->SetComponent(0, 0, value);
    return spoilt;
  };
  for (const double bad : { 0.0, -1.0, NaN, Infinity })
  {
    ExpectMessage(check, "ElementSize " + std::to_string(bad), field("ElementSize", bad), "\"ElementSize\"");
    // The longest list counts then.
    ExpectInk(check, "StipplesPerElement " + std::to_string(bad), field("StipplesPerElement", bad),
      0.99 * usual, 1.01 * usual);
    if (bad != 0.0)
    {
      FindInk(check, "ElementKind " + std::to_string(bad), field("ElementKind", bad));
    }
  }
  // As if there were room for many more stipples, or for none.
  for (const double size : { 1e-30, 1e30 })
  {
    const double all = 120.0 * 120.0;
    ExpectAbout(
      check, "ElementSize " + std::to_string(size), field("ElementSize", size), size > 1.0 ? all : 0.0);
    ExpectAbout(check, "StipplesPerElement " + std::to_string(size), field("StipplesPerElement", size),
      size > 1.0 ? 0.0 : all);
  }
}

/// Surfaces that hide nothing, and one that hides half of what lies behind it.
void TestOccluders(InkTestChecks& check)
{
  const Data voxels = InkTestStipples::SphereVoxels(1.0, 0.15, 6);
  const double usual = FindInk(check, "voxels", voxels);
  const auto expect =
    [&](const std::string& name, const std::vector<std::array<double, 3>>& corners, double least, double most)
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> triangles;
    for (const std::array<double, 3>& corner : corners)
    {
      points->InsertNextPoint(corner.data());
    }
    for (vtkIdType n = 0; n + 2 < points->GetNumberOfPoints(); n += 3)
    {
      triangles->InsertNextCell({ n, n + 1, n + 2 });
    }
    vtkNew<vtkPolyData> surface;
    surface->SetPoints(points);
    surface->SetPolys(triangles);
    const auto hide = [&](StippleScene& scene) { scene.Mapper->SetSurfaceData(surface); };
    ExpectInk(check, "hidden by " + name, voxels, least * usual, most * usual, hide);
  };
  expect("nothing", {}, 0.999, 1.001);
  expect("a line", { { -1.0, 0.0, 3.0 }, { 0.0, 0.0, 3.0 }, { 1.0, 0.0, 3.0 } }, 0.999, 1.001);
  expect("a point", { { 0.0, 0.0, 3.0 }, { 0.0, 0.0, 3.0 }, { 0.0, 0.0, 3.0 } }, 0.999, 1.001);
  expect(
    "corners that are none", { { NaN, 0.0, 3.0 }, { 9.0, 0.0, 3.0 }, { 0.0, Infinity, 3.0 } }, 0.999, 1.001);
  expect("a far triangle", { { 1e9, 0.0, 3.0 }, { 1e9, 9.0, 3.0 }, { 1e9 + 9.0, 0.0, 3.0 } }, 0.999, 1.001);
  expect("half a plane", { { 0.0, -1e6, 1.5 }, { 1e6, 0.0, 1.5 }, { 0.0, 1e6, 1.5 } }, 0.4, 0.6);
}

/// A matrix of the actor's, with shear and mirror, gives the picture of what it makes of the data.
void TestMatrices(InkTestChecks& check)
{
  const Data voxels = InkTestStipples::SphereVoxels(1.0, 0.1, 8);
  const Data surface = InkTestStipples::SphereSurface(1.0, 500, 8);
  for (const std::array<double, 9>& m : { std::array{ -1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 },
         std::array{ 1.0, 0.8, 0.0, 0.0, 1.0, 0.3, 0.0, 0.0, 1.0 },
         std::array{ 1.0, 0.5, 0.0, 0.0, -2.0, 0.0, 0.3, 0.0, 0.5 },
         std::array{ 1e-9, 0.0, 0.0, 0.0, -1e-9, 0.0, 0.0, 0.0, 1e-9 },
         std::array{ 1e9, 0.0, 0.0, 0.0, 1e9, 1e9, 0.0, 0.0, 2e9 } })
  {
    vtkNew<vtkMatrix4x4> matrix;
    double rows[3][3];
    double inverse[3][3];
    for (int i = 0; i < 9; ++i)
    {
      matrix->SetElement(i / 3, i % 3, m[i]);
      rows[i / 3][i % 3] = m[i];
    }
    vtkMath::Invert3x3(rows, inverse);
    const double size = std::cbrt(std::abs(vtkMath::Determinant3x3(rows)));
    for (const Data& data : { voxels, surface })
    {
      Data moved = vtkSmartPointer<vtkPolyData>::New();
      moved->DeepCopy(data);
      for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
      {
        double p[3];
        moved->GetPoint(i, p);
        vtkMath::Multiply3x3(rows, p, p);
        moved->GetPoints()->SetPoint(i, p);
      }
      vtkDataArray* normals = moved->GetCellData()->GetArray("Normals");
      double transposed[3][3];
      vtkMath::Transpose3x3(inverse, transposed);
      for (vtkIdType e = 0; e < normals->GetNumberOfTuples(); ++e)
      {
        double n[3];
        normals->GetTuple(e, n);
        vtkMath::Multiply3x3(transposed, n, n);
        vtkMath::Normalize(n);
        normals->SetTuple(e, n);
      }
      vtkDataArray* sizes = moved->GetFieldData()->GetArray("ElementSize");
      sizes->SetComponent(0, 0, size * sizes->GetComponent(0, 0));

      StippleScene expected(moved, 120, 120);
      StippleScene scene(data, 120, 120);
      scene.Actor->SetUserMatrix(matrix);
      for (StippleScene* one : { &expected, &scene })
      {
        // What is nearer than the near plane, and depth's middle, is found from the data's own box.
        one->Mapper->DistanceOff();
        one->Mapper->ResolutionOff();
        vtkCamera* camera = one->Renderer->GetActiveCamera();
        camera->SetPosition(0.34, 0.0, 0.94);
        camera->SetFocalPoint(0.0, 0.0, 0.0);
        camera->ParallelProjectionOn();
        // VTK finds the clipping range by the scale from before it.
        one->Renderer->ResetCamera(moved->GetBounds());
        one->Renderer->ResetCamera(moved->GetBounds());
      }
      const InkTestImage wanted(expected.Window);
      const int different = InkTestImage(scene.Window).CountDifferent(wanted, 40);
      check(wanted.Ink() > 50.0 && different < 40, "the picture of the moved data with a matrix of ", m[0],
        ' ', m[1], ' ', m[4], ", ink ", wanted.Ink(), ", found ", InkTestImage(scene.Window).Ink(), ", ",
        different, " pixels differ");
    }
  }
}

/// Cameras within the object, on a stipple, far and near; odd windows.
void TestViews(InkTestChecks& check)
{
  struct Expected
  {
    std::string Kind;
    Data Stipples;
    std::array<double, 2> Within; ///< in perspective and parallel
    std::array<double, 2> Outside;
    std::array<double, 2> OneElement;
    double FromAStipple;
    std::array<double, 3> Angles;  ///< of 2 degrees, 0.002, 179
    std::array<double, 3> Windows; ///< of one pixel, a column, a row
    double Dark;
  };
  // Of a surface, only what faces the eye is drawn.
  const Expected volume{ "volume", InkTestStipples::SphereVoxels(1.0, 0.1, 8), { 1970.0, 2220.0 },
    { 5240.0, 3590.0 }, { 4160.0, 6260.0 }, 1995.0, { 12130.0, 0.0, 0.016 }, { 0.016, 0.039, 0.039 },
    2320.0 };
  const Expected surface{ "surface", InkTestStipples::SphereSurface(1.0, 800, 8), { 0.0, 0.0 },
    { 6430.0, 4870.0 }, { 14390.0, 13260.0 }, 0.0, { 12220.0, 13510.0, 0.063 }, { 0.027, 0.078, 0.071 },
    3500.0 };
  for (const Expected& expected : { volume, surface })
  {
    const std::string& kind = expected.Kind;
    const Data& data = expected.Stipples;
    const double usual = FindInk(check, kind, data);
    const auto look = [](double from, double to, bool parallel, double scale)
    {
      return [=](StippleScene& scene)
      {
        scene.Mapper->LightingOff();
        // Nothing is drawn of what is farthest, as all is that is seen from within.
        scene.Mapper->DistanceOff();
        vtkCamera* camera = scene.Renderer->GetActiveCamera();
        camera->SetPosition(0.0, 0.0, from);
        camera->SetFocalPoint(0.0, 0.0, to);
        camera->SetParallelProjection(parallel);
        camera->SetParallelScale(scale);
        scene.Renderer->ResetCameraClippingRange();
      };
    };
    for (const bool parallel : { false, true })
    {
      const std::string how = kind + (parallel ? ", parallel" : "");
      ExpectAbout(
        check, how + " from within", data, expected.Within[parallel], look(0.0, -1.0, parallel, 1.2));
      ExpectAbout(
        check, how + " from outside", data, expected.Outside[parallel], look(4.0, 0.0, parallel, 1.2));
      // One element fills the window: there is more ink than in many drawings of many elements.
      ExpectAbout(
        check, how + " one element", data, expected.OneElement[parallel], look(1.06, 0.0, parallel, 0.02));
      ExpectInk(check, how + " far away", data, 0.0, 0.032, look(1e4, 0.0, parallel, 1e3));
    }
    double p[3];
    data->GetPoint(data->GetNumberOfPoints() / 2, p);
    const auto onStipple = [&p](StippleScene& scene)
    {
      scene.Mapper->LightingOff();
      scene.Mapper->DistanceOff();
      scene.Renderer->GetActiveCamera()->SetPosition(p);
      scene.Renderer->GetActiveCamera()->SetFocalPoint(-p[0], -p[1], -p[2] - 0.1);
      scene.Renderer->ResetCameraClippingRange();
    };
    ExpectAbout(check, kind + " from a stipple", data, expected.FromAStipple, onStipple);
    // A voxel in the window; a thousandth of one, where OpenGL's points are too small and a volume has none
    // in the middle; all in half a pixel.
    for (int i = 0; i < 3; ++i)
    {
      const double angle = std::array{ 2.0, 0.002, 179.0 }[i];
      const auto open = [angle](StippleScene& scene)
      {
        scene.Mapper->LightingOff();
        scene.Renderer->GetActiveCamera()->SetViewAngle(angle);
        scene.Renderer->ResetCameraClippingRange();
      };
      const std::string name = kind + ", view angle " + std::to_string(angle);
      (angle > 90.0 ? ExpectPale : ExpectAbout)(check, name, data, expected.Angles[i], open);
    }
    for (const std::array<double, 2>& range :
      { std::array{ 1e-6, 1e9 }, std::array{ 3.9, 3.901 }, std::array{ 1e3, 1e4 } })
    {
      const auto clip = [&range](StippleScene& scene)
      { scene.Renderer->GetActiveCamera()->SetClippingRange(range[0], range[1]); };
      // All of it, or none where it lies before or behind the planes.
      const double seen = range[0] < 1.0 ? usual : 0.0;
      ExpectInk(check, kind + ", clipping range from " + std::to_string(range[0]), data, 0.999 * seen,
        1.001 * seen, clip);
    }
    // One pixel, a column of them, and a viewport without any.
    for (int i = 0; i < 3; ++i)
    {
      const std::array<int, 2> size =
        std::array{ std::array{ 1, 1 }, std::array{ 1, 120 }, std::array{ 120, 1 } }[i];
      const auto shrink = [&size](StippleScene& scene)
      {
        scene.Window->SetSize(size[0], size[1]);
        scene.Renderer->ResetCamera();
      };
      ExpectPale(check, kind + " in a window of " + std::to_string(size[0]) + " x " + std::to_string(size[1]),
        data, expected.Windows[i], shrink);
    }
    const auto noViewport = [](StippleScene& scene) { scene.Renderer->SetViewport(0.5, 0.5, 0.5, 0.5); };
    // The window stays black there: no renderer has been in it.
    FindInk(check, kind + " in a viewport of no size", data, noViewport);
    const auto dark = [](StippleScene& scene)
    {
      scene.Renderer->RemoveAllLights();
      scene.Renderer->AutomaticLightCreationOff();
    };
    ExpectAbout(check, kind + " without lights", data, expected.Dark, dark);
    const auto bright = [](StippleScene& scene)
    {
      for (int i = 0; i < 12; ++i)
      {
        vtkNew<vtkLight> light;
        light->SetLightTypeToCameraLight();
        light->SetIntensity(1e30);
        scene.Renderer->AddLight(light);
      }
    };
    ExpectAbout(check, kind + " in the light of twelve suns", data, 0.0, bright);
    const auto clear = [](StippleScene& scene) { scene.Actor->GetProperty()->SetOpacity(0.0); };
    ExpectInk(check, kind + " of no opacity", data, 0.0, 0.0, clear);
  }
}

/// All six sliders at both ends under all presets, on volumes and surfaces.
void TestSliders(InkTestChecks& check)
{
  for (const auto& [kind, data] :
    { std::pair<std::string, Data>("volume", InkTestStipples::SphereVoxels(1.0, 0.1, 8)),
      std::pair<std::string, Data>("surface", InkTestStipples::SphereSurface(1.0, 500, 8)) })
  {
    StippleScene scene(data, 60, 60);
    vtkNew<InkTestMessages> messages;
    messages->Observe(scene.Mapper);
    vtkNew<vtkInkStippleControls> controls;
    for (int preset = 0; preset < vtkInkStippleControls::GetNumberOfPresets(); ++preset)
    {
      controls->SetPreset(vtkInkStippleControls::GetPresetName(preset));
      double paper[3];
      controls->GetPaperColor(paper);
      scene.Renderer->SetBackground(paper);
      for (int ends = 0; ends < 64; ++ends)
      {
        controls->SetGradient(ends & 1 ? 1e30 : -1e30);
        controls->SetSharpness(ends >> 1 & 1);
        controls->SetOrientation(ends >> 2 & 1);
        controls->SetDistance(ends >> 3 & 1);
        controls->SetInterior(ends >> 4 & 1);
        controls->SetColor(ends >> 5 & 1);
        controls->Apply(scene.Mapper);
        const InkTestImage image(scene.Window);
        const int paperGray = static_cast<int>(255.0 * paper[0]);
        double marks = 0.0;
        for (int y = 0; y < 60; ++y)
        {
          for (int x = 0; x < 60; ++x)
          {
            marks += std::abs(image.Gray(x, y) - paperGray) / 255.0;
          }
        }
        // No ink for gradients, all of it at the thinnest silhouettes, light everywhere: as good as nothing.
        const bool lightest = (ends & 7) == 6;
        check(marks >= (lightest ? 0.0 : 0.6) && marks < 2600.0, kind, ", ", controls->GetPreset(), ", ends ",
          ends, ": a drawing, found marks of ", marks, " pixels");
      }
    }
    check(messages->Messages.empty(), kind, ": no message from any slider");
  }
  vtkNew<vtkInkStippleControls> controls;
  vtkNew<InkTestMessages> messages;
  messages->Observe(controls);
  controls->SetGradient(0.3);
  controls->SetGradient(NaN);
  messages->Expect(check, "a slider that is not a number", { "from 0 to 1, found nan" });
  check(controls->GetGradient() == 0.3, "the slider where it was, found ", controls->GetGradient());
  controls->SetGradient(Infinity);
  controls->SetSharpness(-Infinity);
  check(controls->GetGradient() == 1.0 && controls->GetSharpness() == 0.0, "sliders at their ends");
}

} // namespace

int TestStippleMapperExtremes(int, char*[])
{
  InkTestChecks check;
  // Whatever else has something to say, shaders above all.
  vtkNew<vtkStringOutputWindow> output;
  vtkOutputWindow::SetInstance(output);
  TestPlaces(check);
  TestValues(check);
  TestShapes(check);
  TestMeshes(check);
  TestSpoilt(check);
  TestOccluders(check);
  TestMatrices(check);
  TestViews(check);
  TestSliders(check);
  check(output->GetOutput().find("ERROR") == std::string::npos, "no errors, found ", output->GetOutput());
  return check.Result();
}
