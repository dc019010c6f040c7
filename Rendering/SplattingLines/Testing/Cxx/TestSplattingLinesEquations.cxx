// SPDX-License-Identifier: BSD-3-Clause
// Splats as published: every pixel against equations 1 and 2 of Zhang et al. 2014 and E = tanh(phi (I1 - tau
// I2)), worked out on the CPU from the points alone.
#include "InkTestChecks.h"
#include "InkTestImage.h"
#include "SplattingLinesScene.h"

#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace
{

struct Splat
{
  std::array<double, 3> Position;
  std::array<double, 3> Normal;
  double Radius;
};

/// Points in the plane z = 0 whose normals wave, and whose radii differ.
std::vector<Splat> MakeSplats()
{
  std::vector<Splat> splats;
  for (int i = 0; i < 11; ++i)
  {
    for (int j = 0; j < 11; ++j)
    {
      const double x = 0.1 * i - 0.5;
      const double y = 0.1 * j - 0.5;
      const double nx = 0.25 * std::sin(12.0 * x);
      const double ny = 0.2 * std::cos(9.0 * y);
      splats.push_back(
        { { x, y, 0.0 }, { nx, ny, std::sqrt(1.0 - nx * nx - ny * ny) }, 0.09 + 0.01 * ((i + 2 * j) % 3) });
    }
  }
  return splats;
}

vtkSmartPointer<vtkPolyData> ToPolyData(const std::vector<Splat>& splats)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> radii;
  radii->SetName("Radius");
  for (const Splat& splat : splats)
  {
    points->InsertNextPoint(splat.Position.data());
    normals->InsertNextTuple(splat.Normal.data());
    radii->InsertNextValue(static_cast<float>(splat.Radius));
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->AddArray(normals);
  data->GetPointData()->AddArray(radii);
  return data;
}

/// Equation 1 at the line of sight through (x, y), along z; 0 where there is no splat.
double Illumination(const std::vector<Splat>& splats, double x, double y, double lambda, double sigma)
{
  double weighted = 0.0;
  double weights = 0.0;
  for (const Splat& splat : splats)
  {
    const double dx = x - splat.Position[0];
    const double dy = y - splat.Position[1];
    const double dz = -(splat.Normal[0] * dx + splat.Normal[1] * dy) / splat.Normal[2];
    const double distance2 = dx * dx + dy * dy + dz * dz;
    const double r = lambda * splat.Radius;
    if (distance2 <= r * r)
    {
      // Equation 2.
      const double variance = r * r * sigma * sigma;
      const double w = std::exp(-distance2 / (2.0 * variance)) / (2.0 * std::acos(-1.0) * variance);
      weighted += w * splat.Normal[2]; // f_i: the light is at the viewer
      weights += w;
    }
  }
  return weights > 0.0 ? weighted / weights : 0.0;
}

} // namespace

int TestSplattingLinesEquations(int, char*[])
{
  InkTestChecks check;
  const std::vector<Splat> splats = MakeSplats();
  SplattingLinesScene scene(ToPolyData(splats));
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(0.0, 0.0, 3.0);
  camera->SetParallelScale(0.4); // inside the points, so that every pixel is covered
  scene.Renderer->ResetCameraClippingRange();
  scene.Mapper->AsPublishedOn();

  struct Parameters
  {
    double Lambda, Tau, Phi, Sigma;
  };
  for (const Parameters& p : { Parameters{ 1.5, 1.0, 40.0, 0.4 }, Parameters{ 1.2, 1.01, 20.0, 0.3 },
         Parameters{ 1.8, 1.0, 200.0, 0.6 }, Parameters{ 0.8, 1.05, 40.0, 0.4 },
         Parameters{ 0.4, 1.05, 40.0, 0.4 }, Parameters{ 3.0, 1.0, 200.0, 0.4 } })
  {
    scene.Mapper->SetLambda(p.Lambda);
    scene.Mapper->SetTau(p.Tau);
    scene.Mapper->SetPhi(p.Phi);
    scene.Mapper->SetSigma(p.Sigma);
    const InkTestImage image(scene.Window);
    int wrong = 0;
    int worst = 0;
    int darkest = 255;
    for (int j = 0; j < image.GetHeight(); ++j)
    {
      for (int i = 0; i < image.GetWidth(); ++i)
      {
        const double x = ((i + 0.5) / image.GetWidth() - 0.5) * 0.8;
        const double y = ((j + 0.5) / image.GetHeight() - 0.5) * 0.8;
        const double difference = Illumination(splats, x, y, p.Lambda, p.Sigma) -
          p.Tau * Illumination(splats, x, y, p.Lambda, 1.6 * p.Sigma);
        const double ink = std::max(0.0, -std::tanh(p.Phi * difference));
        const int expected = static_cast<int>(std::lround(255.0 * (1.0 - ink)));
        const int error = std::abs(image.Gray(i, j) - expected);
        // A rim that passes through a pixel's centre may go either way: a jump of the truncated Gaussian.
        wrong += error > 2;
        worst = std::max(worst, error);
        darkest = std::min(darkest, expected);
      }
    }
    const int pixels = image.GetWidth() * image.GetHeight();
    check(darkest < 200, "lines in the expected picture; the darkest pixel is ", darkest);
    check(wrong <= pixels / 10000, "the equations' brightness within 2 of 255 at lambda ", p.Lambda, ", tau ",
      p.Tau, ", phi ", p.Phi, ", sigma ", p.Sigma, "; ", wrong, " of ", pixels,
      " pixels are not, the worst by ", worst);
  }

  scene.Mapper->AsPublishedOff();
  const InkTestImage refined(scene.Window);
  scene.Mapper->AsPublishedOn();
  check(refined.CountDifferent(InkTestImage(scene.Window), 8) > 100, "AsPublished to make a difference");
  return check.Result();
}
