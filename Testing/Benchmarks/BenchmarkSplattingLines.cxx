// SPDX-License-Identifier: BSD-3-Clause
// Frames of vtkInkSplattingLinesMapper against VTK's own ways of drawing the same points, in the same window
// from the same cameras: opaque discs of the points' radius by vtkPointGaussianMapper, and plain OpenGL
// points as wide as the illumination splats are on average, by vtkPolyDataMapper, without light. 1024 x 768
// pixels; the camera moves by a degree a frame, and all draw the same frames in turn. Times are medians.
//
// The rows are those of Zhang et al. (2014), Tables 1 and 2, beside the frames a second that they report.
// Where their data are not at hand, a bumpy sphere of as many points, or shells in as many voxels, stand in;
// meshes have the 1 million samples that they name as typical. The engine and the bonsai are in Data/;
// bunny.ply and horse.ply are taken from the folder that --data names.
//
// At lambda 3, what a view that nothing changed in takes, and one with another tau and phi, of a whole frame.
//
//   BenchmarkSplattingLines [--frames N] [--quick] [--large] [--data FOLDER] [NAME ...]
//
// --quick: few rows and frames. --large: 20 million points, without peers.

#include "BumpySphere.h"
#include "DrawingBenchmark.h"

#include "vtkInkIsoSurfaceSampler.h"
#include "vtkInkSplattingLinesMapper.h"
#include "vtkInkSurfaceSampler.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkVersion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace
{

Splats SurfaceOf(vtkImageData* image, double isoValue)
{
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputData(image);
  sampler->SetValue(0, isoValue);
  sampler->SetComputeRadius(false);
  sampler->Update();
  const double* spacing = image->GetSpacing();
  return { sampler->GetOutput(), std::cbrt(spacing[0] * spacing[1] * spacing[2]) };
}

/// A mesh's samples, or where the file is missing, a bumpy sphere of as many.
Splats SamplesOf(const std::string& file, int count)
{
  if (!std::ifstream(file))
  {
    return BumpySphere(count);
  }
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(file.c_str());
  vtkNew<vtkInkSurfaceSampler> sampler;
  sampler->SetInputConnection(reader->GetOutputPort());
  sampler->SetNumberOfSamples(count);
  sampler->SetMethodToAutomatic(); // as the paper does
  sampler->Update();
  Splats splats{ sampler->GetOutput(), 0.0 };
  vtkDataArray* radii = splats.Points->GetPointData()->GetArray("Radius");
  for (vtkIdType i = 0; radii && i < radii->GetNumberOfTuples(); ++i)
  {
    splats.Radius += radii->GetComponent(i, 0) / static_cast<double>(radii->GetNumberOfTuples());
  }
  splats.Points->GetPointData()->RemoveArray("Radius");
  return splats;
}

/// The mean diameter on the picture, in pixels, of discs of a radius around the points.
double MeanDiameter(vtkPolyData* points, double radius, vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  double direction[3];
  camera->GetDirectionOfProjection(direction);
  double position[3];
  camera->GetPosition(position);
  const double pixelsAtOne =
    renderer->GetSize()[1] / (2.0 * std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle())));
  double sum = 0.0;
  const vtkIdType count = points->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    double way[3];
    points->GetPoint(i, way);
    vtkMath::Subtract(way, position, way);
    sum += 2.0 * radius * pixelsAtOne / vtkMath::Dot(way, direction);
  }
  return sum / static_cast<double>(std::max<vtkIdType>(count, 1));
}

/// One window in which one of the mappers at a time draws.
struct Scene : public drawing::Window
{
  enum Side
  {
    Lines,
    Culled, ///< lines without what faces away
    Discs,
    Plain,
    Sides
  };

  vtkNew<vtkInkSplattingLinesMapper> LinesMapper;
  vtkNew<vtkPointGaussianMapper> DiscsMapper;
  vtkNew<vtkPolyDataMapper> PlainMapper;
  vtkNew<vtkActor> Actors[Sides];

  explicit Scene(const Splats& splats)
  {
    this->LinesMapper->SetInputData(splats.Points);
    this->LinesMapper->SetRadius(splats.Radius);
    this->DiscsMapper->SetInputData(splats.Points);
    this->DiscsMapper->SetScaleFactor(splats.Radius);
    this->DiscsMapper->EmissiveOff();
    this->DiscsMapper->SetSplatShaderCode("//VTK::Color::Impl\n"
                                          "if (dot(offsetVCVSOutput.xy, offsetVCVSOutput.xy) > 1.0)\n"
                                          "{\n"
                                          "  discard;\n"
                                          "}\n");
    this->PlainMapper->SetInputData(splats.Points);
    vtkMapper* mappers[Sides] = { this->LinesMapper, this->LinesMapper, this->DiscsMapper,
      this->PlainMapper };
    for (int side = 0; side < Sides; ++side)
    {
      this->Actors[side]->SetMapper(mappers[side]);
      this->Renderer->AddActor(this->Actors[side]);
    }
    this->Actors[Culled]->GetProperty()->BackfaceCullingOn();
    this->Actors[Plain]->GetProperty()->LightingOff();
    this->ResetCamera();
  }

  void Show(Side shown)
  {
    for (int side = 0; side < Sides; ++side)
    {
      this->Actors[side]->SetVisibility(side == shown);
    }
  }
};

struct Model
{
  const char* Name;
  const char* Size;
  const char* Data;   ///< what stands in for it, if anything does
  double Reported[3]; ///< frames a second with lambda 1, 3, 6; 0: not told
  std::function<Splats()> Make;
  bool Quick;
  bool Large;
};

void PrintOrDash(const char* format, double number)
{
  if (number > 0.0)
  {
    std::printf(format, number);
  }
  else
  {
    std::printf(" - |");
  }
}

bool Measure(const Model& model, int frames)
{
  double start = drawing::ProcessorTime();
  const Splats splats = model.Make();
  const double making = drawing::ProcessorTime() - start;
  const vtkIdType count = splats.Points->GetNumberOfPoints();
  if (count == 0)
  {
    std::fprintf(stderr, "%s: no points were made\n", model.Name);
    return false;
  }
  const bool hasPeers = !model.Large;
  if (hasPeers)
  {
    drawing::AddVertices(splats.Points);
  }
  Scene scene(splats);
  const std::vector<Scene::Side> all = hasPeers
    ? std::vector{ Scene::Lines, Scene::Culled, Scene::Discs, Scene::Plain }
    : std::vector{ Scene::Lines };
  start = drawing::ProcessorTime();
  for (const Scene::Side side : all) // uploads, compiles
  {
    scene.Show(side);
    scene.Draw();
    if (side == Scene::Lines)
    {
      std::fprintf(stderr, "%s: %lld points made in %.2f s, first frame %.2f s, both of processor time\n",
        model.Name, static_cast<long long>(count), making, drawing::ProcessorTime() - start);
    }
  }
  const double lambdas[] = { 1.0, 3.0, 6.0 };
  for (int i = 0; i < 3; ++i)
  {
    scene.LinesMapper->SetLambda(lambdas[i]);
    const double width =
      std::max(1.0, MeanDiameter(splats.Points, lambdas[i] * splats.Radius, scene.Renderer));
    scene.Actors[Scene::Plain]->GetProperty()->SetPointSize(static_cast<float>(width));
    drawing::Frames times[Scene::Sides];
    drawing::Frames unchanged;
    drawing::Frames changed;
    for (int frame = 0; frame < frames; ++frame)
    {
      scene.Turn(1.0);
      for (const Scene::Side side : all)
      {
        scene.Show(side);
        times[side].Measure([&] { scene.Draw(); });
        if (side == Scene::Lines && lambdas[i] == 3.0)
        {
          unchanged.Measure([&] { scene.Draw(); });
          scene.LinesMapper->SetTau(frame % 2 == 0 ? 1.0 : 0.99);
          scene.LinesMapper->SetPhi(frame % 2 == 0 ? 80.0 : 100.0);
          changed.Measure([&] { scene.Draw(); });
        }
      }
    }
    const auto median = [](const drawing::Frames& of)
    { return of.Processor.empty() ? 0.0 : drawing::Median(of.Processor); };
    const double ours = median(times[Scene::Lines]);
    std::printf("| %s | %s | %s | %.2f M | %g | %.1f |", model.Name, model.Size, model.Data,
      1e-6 * static_cast<double>(count), lambdas[i], width);
    PrintOrDash(" %.1f |", model.Reported[i]);
    std::printf(" %.1f | %.1f |", 1.0 / drawing::Median(times[Scene::Lines].Wall), 1e3 * ours);
    PrintOrDash(" %.1f |", 1e3 * median(times[Scene::Culled]));
    PrintOrDash(" %.2f |", hasPeers ? ours / median(times[Scene::Discs]) : 0.0);
    PrintOrDash(" %.2f |", hasPeers ? ours / median(times[Scene::Plain]) : 0.0);
    PrintOrDash(" %.1f %% |", 100.0 * median(unchanged) / ours);
    PrintOrDash(" %.1f %% |", 100.0 * median(changed) / ours);
    std::printf(" %.0f |\n", drawing::PeakMemory());
    std::fflush(stdout);
  }
  return true;
}

std::vector<Model> Models(const std::string& folder)
{
  const auto sphere = [](vtkIdType count) { return [=] { return BumpySphere(count); }; };
  const auto shells = [](int x, int y, int z)
  { return [=] { return SurfaceOf(drawing::MakeVolume(x, y, z), 30.0); }; };
  const auto file = [](const char* name, double value)
  { return [=] { return SurfaceOf(drawing::ReadVolume(name), value); }; };
  const auto mesh = [&](const char* name, int count)
  { return [path = folder + "/" + name, count] { return SamplesOf(path, count); }; };
  const auto data = [&](const char* name, const char* standIn)
  { return std::ifstream(folder + "/" + name) ? name : standIn; };
  return { { "Bunny", "32K", data("bunny.ply", "sphere"), { 458, 127, 40.3 }, mesh("bunny.ply", 32000), true,
             false },
    { "Lion", "179K", data("horse.ply", "sphere"), { 348, 120, 40.2 }, mesh("horse.ply", 179000), true,
      false },
    { "Buddha", "1.01M", "sphere", { 109, 77, 37.3 }, sphere(1010000), false, false },
    { "Dragon", "1.22M", "sphere", { 86.2, 46.5, 18 }, sphere(1220000), false, false },
    { "Lucy", "9.6M", "sphere", { 14.3, 13.5, 9.5 }, sphere(9600000), false, false },
    { "Lobster", "301x324x56", "shells", { 380, 117, 38.3 }, shells(301, 324, 56), false, false },
    { "Engine", "256x256x110", "its own", { 209, 59, 18.8 }, file("engine.nii.gz", 80.0), true, false },
    { "Teapot", "256x256x178", "shells", { 183, 46, 13.8 }, shells(256, 256, 178), false, false },
    { "Bonsai", "256x256x256", "its own", { 360, 161, 46 }, file("bonsai.nii.gz", 40.0), true, false },
    { "Carp", "256x256x512", "shells", { 220, 75, 24.3 }, shells(256, 256, 512), false, false },
    { "Chest", "384x384x240", "shells", { 151, 77.2, 29.6 }, shells(384, 384, 240), false, false },
    // Table 2 tells no lambda: 23, 24, 18 and 24 frames a second.
    { "Grog-Dragon-Landscape-Nicolo", "1.0M-1.8M faces", data("horse.ply", "sphere"), {},
      mesh("horse.ply", 1000000), false, false },
    { "20-million", "20M", "sphere", {}, sphere(20000000), false, true } };
}

} // namespace

int main(int argc, char* argv[])
{
  int frames = 0;
  bool large = false;
  bool quick = false;
  std::string folder;
  std::vector<std::string> names;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument == "--frames" && i + 1 < argc)
    {
      frames = std::max(1, std::atoi(argv[++i]));
    }
    else if (argument == "--data" && i + 1 < argc)
    {
      folder = argv[++i];
    }
    else if (argument == "--large")
    {
      large = true;
    }
    else if (argument == "--quick")
    {
      quick = true;
    }
    else if (argument.rfind("--", 0) != 0)
    {
      names.push_back(argument);
    }
  }
  frames = frames > 0 ? frames : quick || large ? 3 : 15;
  std::printf(
    "VTK %s; the medians of %d frames; ms and ratios of processor time, frames a second by the clock\n"
    "| model | size | data | points | lambda | pixels | reported, frames a second | ours | "
    "a frame, ms | without back faces, ms | of discs' time | of plain points' | "
    "unchanged view | other tau and phi | peak memory, MiB |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n",
    vtkVersion::GetVTKVersion(), frames);
  std::fflush(stdout);
  for (const Model& model : Models(folder))
  {
    const bool named = std::find(names.begin(), names.end(), model.Name) != names.end();
    const bool chosen = model.Large == large && (model.Quick || !quick);
    if ((named || (names.empty() && chosen)) && !Measure(model, frames))
    {
      return EXIT_FAILURE;
    }
  }
  return EXIT_SUCCESS;
}
