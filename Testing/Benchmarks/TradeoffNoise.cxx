// SPDX-License-Identifier: BSD-3-Clause
// Blue or white noise (Zhang et al. 2014, section 6): how much lines from so many samples of a mesh differ
// from those of many more, against the time to sample and to draw them.

#include "Tradeoff.h"

#include "PictureDifference.h"

#include "SampledMeshes.h"

#include "vtkInkSplattingLinesMapper.h"
#include "vtkInkSurfaceSampler.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace
{

constexpr int WindowSize = 700;
constexpr vtkIdType Reference = 16; // times as many samples
constexpr vtkIdType MostReference = 6'000'000;
constexpr std::size_t LargestSpeck = 8; // pixels

using Picture = std::vector<double>; // darkness

/// A torus with furrows that come and go, of 160,000 triangles.
vtkSmartPointer<vtkPolyData> MakeMesh()
{
  ink::test::Mesh mesh;
  mesh.addPatch(400, 200,
    [](double u, double v)
    {
      const double around = 2.0 * M_PI * (u == 1.0 ? 0.0 : u);
      const double across = 2.0 * M_PI * (v == 1.0 ? 0.0 : v);
      const double tube = 0.45 + 0.025 * std::sin(5.0 * across + 4.0 * around) * (1.0 + std::sin(around));
      const double out = 1.0 + tube * std::cos(across);
      return glm::dvec3(out * std::cos(around), out * std::sin(around), tube * std::sin(across));
    });
  vtkNew<vtkPoints> points;
  for (const glm::dvec3& point : mesh.points)
  {
    points->InsertNextPoint(&point.x);
  }
  vtkNew<vtkCellArray> polys;
  for (const ink::Triangle& triangle : mesh.triangles)
  {
    const vtkIdType corners[3] = { triangle[0], triangle[1], triangle[2] };
    polys->InsertNextCell(3, corners);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(polys);
  return data;
}

vtkSmartPointer<vtkPolyData> Sample(vtkPolyData* mesh, bool blue, vtkIdType count)
{
  vtkNew<vtkInkSurfaceSampler> sampler;
  sampler->SetInputData(mesh);
  sampler->SetMethod(blue ? vtkInkSurfaceSampler::BLUE_NOISE : vtkInkSurfaceSampler::WHITE_NOISE);
  sampler->SetNumberOfSamples(count);
  sampler->ComputePriorityOff();
  sampler->Update();
  return sampler->GetOutput();
}

double RadiusOf(vtkPolyData* samples)
{
  return samples->GetPointData()->GetArray("Radius")->GetComponent(0, 0);
}

class Scene
{
public:
  Scene()
  {
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
    this->Renderer->SetBackground(1.0, 1.0, 1.0);
    this->Window->SetOffScreenRendering(true);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(WindowSize, WindowSize);
    this->Window->AddRenderer(this->Renderer);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, -4.0, 3.6);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
  }

  /// @param splat the size of splats in world units, which says how fine lines are; the discs that hide have
  /// the samples' own
  Picture Draw(vtkPolyData* samples, double splat)
  {
    this->Mapper->SetInputData(samples);
    this->Mapper->SetLambda(splat / RadiusOf(samples));
    this->Renderer->ResetCameraClippingRange();
    this->Window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    this->Window->GetPixelData(0, 0, WindowSize - 1, WindowSize - 1, 0, pixels);
    Picture picture(static_cast<std::size_t>(WindowSize) * WindowSize);
    for (std::size_t i = 0; i < picture.size(); ++i)
    {
      picture[i] = 1.0 - pixels->GetValue(static_cast<vtkIdType>(3 * i)) / 255.0;
    }
    return picture;
  }

private:
  vtkNew<vtkInkSplattingLinesMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

/// The share of ink in spots of a few pixels that touch no other ink.
double Specks(const Picture& picture)
{
  constexpr double dark = 0.1;
  std::vector<char> seen(picture.size());
  double all = 0.0;
  double lonely = 0.0;
  for (std::size_t start = 0; start < picture.size(); ++start)
  {
    if (seen[start] || picture[start] <= dark)
    {
      continue;
    }
    std::vector<std::size_t> spot{ start };
    seen[start] = 1;
    double ink = 0.0;
    for (std::size_t i = 0; i < spot.size(); ++i)
    {
      ink += picture[spot[i]];
      const int x = static_cast<int>(spot[i] % WindowSize);
      const int y = static_cast<int>(spot[i] / WindowSize);
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, WindowSize - 1); ++v)
      {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, WindowSize - 1); ++u)
        {
          const std::size_t other = static_cast<std::size_t>(v) * WindowSize + static_cast<std::size_t>(u);
          if (!seen[other] && picture[other] > dark)
          {
            seen[other] = 1;
            spot.push_back(other);
          }
        }
      }
    }
    all += ink;
    lonely += spot.size() <= LargestSpeck ? ink : 0.0;
  }
  return lonely / all;
}

} // namespace

int main()
{
  Tradeoff knob("Noise (vtkInkSurfaceSampler)",
    "Take blue noise below 500,000 samples and white noise from there on, as Zhang et al. do: white noise "
    "then leaves no "
    "specks, and differs little more than 100,000 blue samples, the default, in a quarter of the time of as "
    "many blue "
    "ones. Of fewer, white ones differ two to five times as much as blue ones do.",
    "ink that differs from that of 16 times as many samples (at most 6 million), of all; specks: the share "
    "of ink in "
    "spots of up to 8 pixels",
    "sampling a torus with furrows and drawing a frame of 700x700");
  const auto mesh = MakeMesh();
  Scene scene;
  Tradeoff::PrintHeader();
  for (const vtkIdType count : { 25'000, 50'000, 100'000, 200'000, 500'000, 1'000'000 })
  {
    const auto many = Sample(mesh, false, std::min(Reference * count, MostReference));
    const double splat = 2.5 * RadiusOf(Sample(mesh, true, count));
    const Picture reference = scene.Draw(many, splat);
    for (const bool blue : { false, true })
    {
      const Picture picture = scene.Draw(Sample(mesh, blue, count), splat);
      knob.Add(
        std::to_string(count) + (blue ? " blue" : " white"),
        [&scene, mesh, blue, count, splat] { scene.Draw(Sample(mesh, blue, count), splat); },
        { { "difference", ink::pictureDifference(reference, picture) }, { "specks", Specks(picture) } },
        blue && count == 100'000 ? Tradeoff::Default : Tradeoff::Choice);
    }
  }
  knob.Print(2);
  return 0;
}
