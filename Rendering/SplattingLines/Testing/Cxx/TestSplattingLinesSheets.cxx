// SPDX-License-Identifier: BSD-3-Clause
// How near to each other two sheets may be to be told apart, in radii of their points: planes and spheres,
// one behind the other, as documented in Documentation/splatting-lines.md.
#include "InkTestImage.h"
#include "InkTestPoints.h"
#include "SplattingLinesScene.h"

#include "vtkMath.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace
{

constexpr double Distance = 4.0; // of the camera

struct View
{
  bool Parallel;
  double Angle; ///< degrees that the camera goes around
  double Height;
};

std::string ToString(const View& view)
{
  return (view.Parallel ? " seen with parallel rays from " : " seen in perspective from ") +
    std::to_string(static_cast<int>(view.Angle)) + " degrees";
}

class SheetsScene : public SplattingLinesScene
{
public:
  SheetsScene(vtkPolyData* points, double radius, const View& view)
    : SplattingLinesScene((InkTestPoints::SetRadius(points, radius), points))
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetPosition(0.0, 0.0, Distance);
    camera->SetParallelProjection(view.Parallel);
    camera->SetParallelScale(0.5 * view.Height);
    camera->SetViewAngle(2.0 * vtkMath::DegreesFromRadians(std::atan(0.5 * view.Height / Distance)));
    camera->Azimuth(view.Angle);
    this->Renderer->ResetCameraClippingRange();
  }
  void ShowLayer(int shown)
  {
    this->Mapper->HiddenLayersOn();
    for (int layer = 0; layer < 2; ++layer)
    {
      this->Mapper->SetLayerStrength(layer, layer == shown ? 1.0 : 0.0);
    }
  }
};

/// Two planes, the second behind the first.
vtkSmartPointer<vtkPolyData> MakePlanes(double radius, double gap)
{
  auto front = InkTestPoints::Plane(1.6, radius / 1.2);
  return InkTestPoints::Join(front, InkTestPoints::Transform(front, 1.0, { 0.0, 0.0, -gap }));
}

/// The part of the picture where the plane behind is a layer of its own, at so many radii.
double ShareOfSecondLayer(double radius, double radii, const View& view, bool asPublished = false)
{
  SheetsScene scene(MakePlanes(radius, radii * radius), radius, view);
  scene.ShowLayer(1);
  scene.Mapper->SetAsPublished(asPublished);
  scene.Mapper->SetTau(1.2); // ink everywhere
  scene.Mapper->SetPhi(500.0);
  return InkTestImage(scene.Window).CountDark() / (200.0 * 200.0);
}

/// The share of a ring's directions in which there is ink within some pixels of it.
double RingIn(const InkTestImage& image, double radius, const View& view)
{
  const double seen = view.Parallel ? radius : Distance * std::tan(std::asin(radius / Distance));
  int dark = 0;
  for (int degree = 0; degree < 360; ++degree)
  {
    const double angle = vtkMath::RadiansFromDegrees(double(degree));
    bool found = false;
    for (int across = -3; across <= 3; ++across)
    {
      const double r = 200.0 / view.Height * seen - 1.0 + across;
      found = found ||
        image.IsDark(
          static_cast<int>(100.0 + r * std::cos(angle)), static_cast<int>(100.0 + r * std::sin(angle)));
    }
    dark += found;
  }
  return dark / 360.0;
}

} // namespace

/// Planes are two layers from the measured distance on; what is nearer is the unevenness of one.
TEST(SplattingLinesSheets, Planes)
{
  struct Case
  {
    double Radius; ///< 20 pixels, or 6
    double Angle;
    double Apart; ///< measured, in radii
  };
  for (const Case& one : { Case{ 0.05, 0.0, 0.59 }, { 0.05, 45.0, 0.63 }, { 0.05, 65.0, 0.63 },
         { 0.015, 0.0, 0.59 }, { 0.015, 45.0, 0.74 }, { 0.015, 65.0, 0.8 } })
  {
    for (bool parallel : { true, false })
    {
      const View view{ parallel, one.Angle, 0.5 };
      const std::string what = ToString(view) + " with points of radius " + std::to_string(one.Radius);
      const double apart = ShareOfSecondLayer(one.Radius, 1.03 * one.Apart, view);
      EXPECT_GT(apart, 0.99) << "two layers of planes " << 1.03 * one.Apart << " radii apart" << what
                             << ", found " << apart << " of the second";
      const double merged = ShareOfSecondLayer(one.Radius, 0.7 * one.Apart, view);
      EXPECT_LT(merged, 0.01) << "one layer of planes " << 0.7 * one.Apart << " radii apart" << what
                              << ", found " << merged << " of a second";
    }
  }
}

/// As published, a splat's depth may differ by one and a half radii, whatever its slope.
TEST(SplattingLinesSheets, AsPublished)
{
  for (double angle : { 0.0, 45.0 })
  {
    const View view{ true, angle, 0.5 };
    const double along = std::cos(vtkMath::RadiansFromDegrees(angle)); // of the view's distance
    const double merged = ShareOfSecondLayer(0.05, 1.45 * along, view, true);
    const double apart = ShareOfSecondLayer(0.05, 1.55 * along, view, true);
    EXPECT_TRUE(merged < 0.01 && apart > 0.99)
      << "two layers from 1.5 radii along the view on as published" << ToString(view) << ", found " << merged
      << " of the second before, " << apart << " behind";
  }
}

/// Each of two spheres within each other has its outline, in its own layer.
TEST(SplattingLinesSheets, Outlines)
{
  for (double radius : { 0.05, 0.015 })
  {
    for (bool parallel : { true, false })
    {
      const View view{ parallel, 0.0, 2.5 };
      // Measured: from 0.93 radii on with 4 pixels, from 1.48 with 1.2.
      const double inner = 1.0 - (radius > 0.04 ? 1.05 : 1.6) * radius;
      SheetsScene scene(InkTestPoints::Join(InkTestPoints::Sphere(1.0, radius / 1.2),
                          InkTestPoints::Sphere(inner, radius / 1.2)),
        radius, view);
      for (int layer : { 0, 1 })
      {
        scene.ShowLayer(layer);
        const double ring = RingIn(InkTestImage(scene.Window), layer == 0 ? 1.0 : inner, view);
        EXPECT_GT(ring, 0.97) << "the outline of layer " << layer << ToString(view)
                              << " with points of radius " << radius << ", found " << ring << " of it";
      }
    }
  }
}

/// Lines of a sheet do not show through another before it.
TEST(SplattingLinesSheets, NothingShowsThrough)
{
  constexpr double radius = 0.015;
  for (bool parallel : { true, false })
  {
    const View view{ parallel, 45.0, 0.5 };
    const auto draw = [&](double wave)
    {
      // Measured: from 0.93 radii on.
      auto planes = MakePlanes(radius, radius);
      vtkDataArray* normals = planes->GetPointData()->GetArray("Normals");
      for (vtkIdType i = planes->GetNumberOfPoints() / 2; i < planes->GetNumberOfPoints(); ++i)
      {
        const double angle = wave * std::sin(planes->GetPoint(i)[0] / (3.0 * radius));
        normals->SetTuple3(i, std::sin(angle), 0.0, std::cos(angle));
      }
      SheetsScene scene(planes, radius, view);
      scene.Mapper->SetTau(1.0);
      scene.Mapper->SetPhi(500.0);
      return InkTestImage(scene.Window);
    };
    const InkTestImage flat = draw(0.0);
    const InkTestImage waving = draw(0.1);
    // Of splats whose middle is beyond the picture it is not known whether they are hidden.
    int through = 0;
    for (int y = 50; y < 150; ++y)
    {
      for (int x = 50; x < 150; ++x)
      {
        through += std::abs(flat.Gray(x, y) - waving.Gray(x, y)) > 8;
      }
    }
    EXPECT_EQ(through, 0) << "nothing of a hidden plane's waves" << ToString(view) << ", found " << through
                          << " pixels";
  }
}
