// SPDX-License-Identifier: BSD-3-Clause
// vtkInkStippleMapper and odd views: what hides stipples, matrices, cameras and windows; with positions in
// either precision.
#include "InkTestStipples.h"
#include "StippleInk.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace
{

using namespace StippleInk;

class StippleMapperViews : public StippleInk::Test
{
};

} // namespace

/// Surfaces that hide nothing, and one that hides half of what lies behind it.
TEST_F(StippleMapperViews, Occluders)
{
  const Data voxels = InkTestStipples::SphereVoxels(1.0, 0.15, 6);
  const double usual = FindInk("voxels", voxels);
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
    ExpectInk("hidden by " + name, voxels, least * usual, most * usual, hide);
  };
  expect("nothing", {}, 0.999, 1.001);
  expect("a line", { { -1.0, 0.0, 3.0 }, { 0.0, 0.0, 3.0 }, { 1.0, 0.0, 3.0 } }, 0.999, 1.001);
  expect("a point", { { 0.0, 0.0, 3.0 }, { 0.0, 0.0, 3.0 }, { 0.0, 0.0, 3.0 } }, 0.999, 1.001);
  expect(
    "corners that are none", { { NaN, 0.0, 3.0 }, { 9.0, 0.0, 3.0 }, { 0.0, Infinity, 3.0 } }, 0.999, 1.001);
  expect("a far triangle", { { 1e9, 0.0, 3.0 }, { 1e9, 9.0, 3.0 }, { 1e9 + 9.0, 0.0, 3.0 } }, 0.999, 1.001);
  expect("half a plane", { { 0.0, -1e6, 1.5 }, { 1e6, 0.0, 1.5 }, { 0.0, 1e6, 1.5 } }, 0.485, 0.505);
}

/// A matrix of the actor's, with shear and mirror, gives the picture of what it makes of the data.
TEST_F(StippleMapperViews, Matrices)
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
      EXPECT_TRUE(wanted.Ink() > 50.0 && different < 40)
        << "the picture of the moved data with a matrix of " << m[0] << ' ' << m[1] << ' ' << m[4] << ", ink "
        << wanted.Ink() << ", found " << InkTestImage(scene.Window).Ink() << ", " << different
        << " pixels differ";
    }
  }
}

/// Cameras within the object, on a stipple, far and near; odd windows.
TEST_F(StippleMapperViews, Views)
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
    const double usual = FindInk(kind, data);
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
      ExpectAbout(how + " from within", data, expected.Within[parallel], look(0.0, -1.0, parallel, 1.2));
      ExpectAbout(how + " from outside", data, expected.Outside[parallel], look(4.0, 0.0, parallel, 1.2));
      // One element fills the window: there is more ink than in many drawings of many elements.
      ExpectAbout(how + " one element", data, expected.OneElement[parallel], look(1.06, 0.0, parallel, 0.02));
      ExpectInk(how + " far away", data, 0.0, 0.032, look(1e4, 0.0, parallel, 1e3));
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
    ExpectAbout(kind + " from a stipple", data, expected.FromAStipple, onStipple);
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
      (angle > 90.0 ? ExpectPale : ExpectAbout)(name, data, expected.Angles[i], open);
    }
    for (const std::array<double, 2>& range :
      { std::array{ 1e-6, 1e9 }, std::array{ 3.9, 3.901 }, std::array{ 1e3, 1e4 } })
    {
      const auto clip = [&range](StippleScene& scene)
      { scene.Renderer->GetActiveCamera()->SetClippingRange(range[0], range[1]); };
      // All of it, or none where it lies before or behind the planes.
      const double seen = range[0] < 1.0 ? usual : 0.0;
      ExpectInk(
        kind + ", clipping range from " + std::to_string(range[0]), data, 0.999 * seen, 1.001 * seen, clip);
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
      ExpectPale(kind + " in a window of " + std::to_string(size[0]) + " x " + std::to_string(size[1]), data,
        expected.Windows[i], shrink);
    }
    const auto noViewport = [](StippleScene& scene) { scene.Renderer->SetViewport(0.5, 0.5, 0.5, 0.5); };
    // The window stays black there: no renderer has been in it.
    ExpectAbout(kind + " in a viewport of no size", data, 120.0 * 120.0, noViewport);
    const auto dark = [](StippleScene& scene)
    {
      scene.Renderer->RemoveAllLights();
      scene.Renderer->AutomaticLightCreationOff();
    };
    ExpectAbout(kind + " without lights", data, expected.Dark, dark);
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
    ExpectAbout(kind + " in the light of twelve suns", data, 0.0, bright);
    const auto clear = [](StippleScene& scene) { scene.Actor->GetProperty()->SetOpacity(0.0); };
    ExpectInk(kind + " of no opacity", data, 0.0, 0.0, clear);
  }
}
