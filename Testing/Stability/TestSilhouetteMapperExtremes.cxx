// SPDX-License-Identifier: BSD-3-Clause
// vtkInkSilhouetteMapper and odd surfaces and eyes: the right picture, or an empty one.
#include "InkTestImage.h"
#include "InkTestMesh.h"
#include "InkTestMessages.h"
#include "InkTestScene.h"
#include "StabilityChecks.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkInkSilhouetteMapper.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkReverseSense.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace
{

using Data = vtkSmartPointer<vtkPolyData>;
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr int Size = 200;
constexpr double Width = 3.0;

class Scene : public InkTestScene<vtkInkSilhouetteMapper>
{
public:
  explicit Scene(vtkPolyData* data)
    : InkTestScene(data, Size, Size)
  {
    this->Mapper->SetSizeUnitToPixels();
    this->Mapper->SetLineWidth(Width);
    this->Messages->Observe(this->Mapper);
  }
  void LookFrom(double x, double y, double z)
  {
    this->Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
    this->Renderer->GetActiveCamera()->SetPosition(x, y, z);
    this->Renderer->ResetCamera();
  }
  /// Darkness, after lines were checked; `words` as in InkTestMessages.
  double Ink(const std::string& name, const std::vector<std::string>& words = {})
  {
    const double ink = InkTestImage(this->Window).Ink();
    this->Messages->Expect(name, words);
    if (vtkPolyData* lines = this->Mapper->GetContours(this->Renderer, this->Actor))
    {
      CheckValidPoints(name, lines);
    }
    return ink;
  }
  vtkNew<InkTestMessages> Messages;
};

/// The unit ball's points moved; normals are as they were.
Data Ball(const std::function<void(std::array<double, 3>&)>& move = [](std::array<double, 3>&) {})
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(1.0);
  source->SetThetaResolution(96);
  source->SetPhiResolution(64);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  const Data ball = source->GetOutput();
  for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> p;
    ball->GetPoint(i, p.data());
    move(p);
    ball->GetPoints()->SetPoint(i, p.data());
  }
  return ball;
}

double InkOf(const std::string& name, vtkPolyData* data)
{
  return Scene(data).Ink(name);
}

/// Of the unit ball's outline in a window that shows all of its bounding box.
double OutlineInk()
{
  const double angle = std::numbers::pi / 12.0; // half of the view angle
  const double distance = std::sqrt(3.0) / std::sin(angle);
  const double radius = 0.5 * Size / std::sqrt(distance * distance - 1.0) / std::tan(angle);
  return 2.0 * std::numbers::pi * radius * Width;
}

} // namespace

TEST(SilhouetteMapperExtremes, Geometry)
{
  const double usual = InkOf("ball", Ball());
  EXPECT_NEAR(usual / OutlineInk(), 1.0, 0.01);
  const auto expectUsual = [&](const std::string& name, vtkPolyData* data)
  { EXPECT_NEAR(InkOf(name, data) / usual, 1.0, 0.005) << name; };
  for (const double size : { 1e-9, 1e9 })
  {
    expectUsual("size " + std::to_string(size),
      Ball(
        [&](std::array<double, 3>& p)
        {
          for (double& x : p)
          {
            x *= size;
          }
        }));
  }
  expectUsual("far away",
    Ball(
      [](std::array<double, 3>& p) {
        p = { 1e7 + 0.01 * p[0], -1e7 + 0.01 * p[1], 1e7 + 0.01 * p[2] };
      }));
  // Which way faces or normals run does not matter.
  for (const bool cells : { false, true })
  {
    vtkNew<vtkReverseSense> turned;
    turned->SetInputData(Ball());
    turned->SetReverseCells(cells);
    turned->SetReverseNormals(!cells);
    turned->Update();
    expectUsual(cells ? "faces turned" : "normals turned", turned->GetOutput());
  }
}

/// A needle a thousand times as long as thick: a line of a stroke's width, or seen along it a dot.
TEST(SilhouetteMapperExtremes, Needles)
{
  for (const int axis : { 0, 1, 2 })
  {
    const Data needle = Ball([&](std::array<double, 3>& p) { p[axis] *= 1000.0; });
    vtkDataArray* normals = needle->GetPointData()->GetNormals();
    for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
    {
      double n[3];
      normals->GetTuple(i, n);
      n[axis] /= 1000.0; // the wrong length does not matter
      normals->SetTuple(i, n);
    }
    for (const int view : { 0, 2 })
    {
      Scene scene(needle);
      scene.LookFrom(view == 0, 0.0, view == 2);
      const double ink = scene.Ink("needle");
      const InkTestImage image(scene.Window);
      if (view == axis)
      {
        EXPECT_TRUE(ink > 0.5 && ink < 3.0 * Width * Width) << axis << ": " << ink;
      }
      else
      {
        // From one end of the picture to the other. Its two sides are one line, of which only pixels that a
        // stroke covers in part are darker than of one stroke.
        EXPECT_TRUE(ink > 0.98 * Size * Width && ink < 1.2 * Size * Width)
          << axis << " from " << view << ": " << ink;
        const int half = Size / 2;
        const int reach = 3;
        const bool upright = axis == 1;
        EXPECT_EQ(image.CountDark(255),
          upright ? image.CountDark(half - reach, 0, half + reach, Size, 255)
                  : image.CountDark(0, half - reach, Size, half + reach, 255))
          << axis << " from " << view;
      }
    }
  }
}

TEST(SilhouetteMapperExtremes, Eyes)
{
  Scene inside(Ball());
  inside.Renderer->GetActiveCamera()->SetPosition(0.3, 0.2, 0.1);
  inside.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
  inside.Renderer->ResetCameraClippingRange();
  EXPECT_EQ(inside.Ink("inside"), 0.0);

  // From ever farther away, through a lens of ever longer focal length, the picture of a parallel projection.
  constexpr double height = 1.3;
  Scene parallel(Ball());
  vtkCamera* camera = parallel.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(height);
  const double usual = parallel.Ink("parallel");
  EXPECT_NEAR(usual / (std::numbers::pi / height * Size * Width), 1.0, 0.01);
  for (const double distance : { 1e3, 1e5 })
  {
    Scene far(Ball());
    far.Renderer->GetActiveCamera()->SetViewAngle(360.0 / std::numbers::pi * std::atan(height / distance));
    far.Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, distance);
    far.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
    far.Renderer->ResetCameraClippingRange();
    EXPECT_NEAR(far.Ink("far") / usual, 1.0, 0.005) << distance;
  }

  // In the surface itself, and on an axis of symmetry through a point of the mesh.
  for (const double z : { 1.0, 1.0 + 1e-9, 5.0 })
  {
    Scene touching(Ball());
    touching.Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, z);
    touching.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
    touching.Renderer->ResetCameraClippingRange();
    const double ink = touching.Ink("eye at " + std::to_string(z));
    EXPECT_TRUE(z > 2.0 ? ink > 1400.0 : ink < 100.0) << z << ": " << ink;
  }
}

TEST(SilhouetteMapperExtremes, Normals)
{
  const double usual = InkOf("ball", Ball());
  for (const double value : { 0.0, NaN, std::numeric_limits<double>::infinity() })
  {
    // Faces tell instead.
    const Data ball = Ball();
    ball->GetPointData()->GetNormals()->Fill(value);
    EXPECT_NEAR(InkOf("all normals " + std::to_string(value), ball) / usual, 1.0, 0.01) << value;
    const Data some = Ball();
    for (vtkIdType i = 0; i < some->GetNumberOfPoints(); i += 7)
    {
      some->GetPointData()->GetNormals()->SetComponent(i, 1, value);
      some->GetPointData()->GetNormals()->SetComponent(i, 0, value);
      some->GetPointData()->GetNormals()->SetComponent(i, 2, value);
    }
    EXPECT_NEAR(InkOf("some normals " + std::to_string(value), some) / usual, 1.0, 0.01) << value;
  }
}

TEST(SilhouetteMapperExtremes, Shapes)
{
  // Degenerate and non-manifold, of all sizes the same picture.
  std::vector<double> inks;
  for (const double scale : { 1e-9, 1.0, 1e9 })
  {
    Scene scene(InkTestOddMesh(scale));
    inks.push_back(InkTestImage(scene.Window).Ink());
    CheckValidPoints("odd mesh", scene.Mapper->GetContours(scene.Renderer, scene.Actor));
    EXPECT_EQ(scene.Messages->Messages.size(), 2u) << "normals, and a point that is not finite";
    EXPECT_NEAR(inks.back() / inks.front(), 1.0, 0.005) << scale;
  }
  EXPECT_GT(inks[0], 100.0);

  // A square: its border, also where all of it is seen from the edge.
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(7, 7);
  plane->Update();
  Scene square(plane->GetOutput());
  vtkCamera* camera = square.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.0);
  EXPECT_NEAR(square.Ink("square") / (4.0 * 0.5 * Size * Width), 1.0, 0.02);
  square.LookFrom(1.0, 0.0, 0.0);
  camera->SetParallelScale(1.0);
  const double edge = square.Ink("from the edge") / (0.5 * Size * Width);
  EXPECT_TRUE(edge > 0.98 && edge < 1.2) << edge; // as of a needle

  // A hole where a point is missing has a border.
  const Data ball = Ball();
  const double usual = InkOf("ball", ball);
  vtkIdType front = 0;
  for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
  {
    front = ball->GetPoint(i)[2] > ball->GetPoint(front)[2] ? i : front;
  }
  ball->GetPoints()->SetPoint(front, NaN, NaN, NaN);
  Scene hole(ball);
  hole.Renderer->ResetCamera(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0);
  EXPECT_GT(hole.Ink("a point missing", { "faces have points that are not finite" }), usual + 20.0);

  for (const int points : { 0, 1 })
  {
    const auto none = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> few;
    few->SetNumberOfPoints(points);
    none->SetPoints(few);
    if (points == 1)
    {
      few->SetPoint(0, 0.0, 0.0, 0.0);
      vtkNew<vtkCellArray> verts;
      verts->InsertNextCell({ 0 });
      none->SetVerts(verts);
    }
    Scene scene(none);
    EXPECT_EQ(InkTestImage(scene.Window).Ink(), 0.0) << points;
    EXPECT_LE(scene.Messages->Messages.size(), 1u) << points;
  }
}
