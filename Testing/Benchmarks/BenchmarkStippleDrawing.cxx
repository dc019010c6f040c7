// SPDX-License-Identifier: BSD-3-Clause
// Frames of vtkInkStippleMapper with all enhancements on, against plain OpenGL points: as many as the mapper
// draws (those among its stipples that are to be seen from the first camera position), of the mean size of
// their dots, opaque and without light, by VTK's own vtkPolyDataMapper, in the same window from the same
// cameras. 1024 x 768 pixels; the camera moves by a degree a frame, and both draw the same frames in turn.
// The mapper draws each frame twice: blended straight into the picture, with vtkInkStippleActor, and with
// vtkActor in VTK's pass for translucent things. The plain points, too: as above, and half transparent,
// blended straight (VTK 9.2 does not offer that), of the size of the dots with their rims.
//
// The data sets are those of Lu et al. (2003), Table 2; where theirs are not at hand, a sphere, or shells, of
// the same number of polygons or voxels stand in. Further ones by argument: --large draws 50 million
// stipples.
//
//   BenchmarkStippleDrawing [--frames N] [--large] [NAME ...]

#include "DrawingBenchmark.h"

#include "vtkInkStippleActor.h"
#include "vtkInkStippleControls.h"
#include "vtkInkStippleGenerator.h"
#include "vtkInkStippleMapper.h"

#include "Tone/DotCoverage.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkVersion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace
{

vtkSmartPointer<vtkDataSet> MakeMesh(int polygons)
{
  vtkNew<vtkSphereSource> sphere;
  const int side = std::max(3, static_cast<int>(std::lround(std::sqrt(0.5 * polygons))));
  sphere->SetThetaResolution(side);
  sphere->SetPhiResolution(side);
  sphere->Update();
  return sphere->GetOutput();
}

/// Where this VTK has the choice; as a template, so that only then it need be there.
template <typename Renderer>
void BlendStraight(Renderer* renderer)
{
  if constexpr (requires { renderer->SetUseOIT(false); })
  {
    renderer->SetUseOIT(false);
  }
}

/// A window with one actor.
struct Scene : public drawing::Window
{
  vtkNew<vtkActor> Actor;

  explicit Scene(vtkMapper* mapper)
  {
    this->Actor->SetMapper(mapper);
    this->Renderer->AddActor(this->Actor);
    this->ResetCamera();
  }
};

/// As many of the stipples as the mapper draws now straight into the picture, as plain points, and the mean
/// diameter of their dots: dots that 8 bits cannot add up are drawn more rarely instead. None where there are
/// more stipples than vtkInkStippleMapper::EvaluateMarks can look into.
vtkSmartPointer<vtkPolyData> PlainPoints(
  vtkInkStippleMapper* mapper, Scene& window, vtkPolyData* stipples, double& size)
{
  vtkNew<vtkFloatArray> marks;
  auto points = vtkSmartPointer<vtkPolyData>::New();
  points->SetPoints(vtkNew<vtkPoints>());
  size = 0.0;
  if (!mapper->EvaluateMarks(window.Renderer, window.Actor, marks))
  {
    return points;
  }
  for (vtkIdType i = 0; i < marks->GetNumberOfTuples(); ++i)
  {
    const auto diameter = static_cast<float>(marks->GetComponent(i, 2));
    const auto opacity = static_cast<float>(marks->GetComponent(i, 1));
    constexpr float leastIntensity = 8.0f / 255.0f;
    if (ink::thinnedIntensity(
          opacity * ink::dotShape(diameter).intensity, leastIntensity, static_cast<std::uint32_t>(i)) > 0.0f)
    {
      points->GetPoints()->InsertNextPoint(stipples->GetPoint(i));
      size += marks->GetComponent(i, 2);
    }
  }
  const vtkIdType count = points->GetNumberOfPoints();
  size /= std::max<double>(1.0, static_cast<double>(count));
  drawing::AddVertices(points);
  return points;
}

void Measure(const std::string& name, vtkDataSet* data, int perElement, int frames)
{
  vtkNew<vtkInkStippleGenerator> generator;
  generator->SetMaximumStipples(perElement);
  generator->SetInputData(data);
  double start = drawing::ProcessorTime();
  generator->Update();
  const double preprocessing = drawing::ProcessorTime() - start;
  vtkPolyData* stipples = generator->GetOutput();
  const bool isVolume = vtkImageData::SafeDownCast(data) != nullptr;

  vtkNew<vtkInkStippleMapper> mapper;
  mapper->SetInputData(stipples);
  vtkNew<vtkInkStippleControls> controls;
  controls->SetPreset(isVolume ? "anatomy" : "engineering");
  controls->Apply(mapper);
  mapper->SetSizeUnitToPixels();
  mapper->BoundaryOn();
  mapper->SilhouetteOn();
  mapper->ResolutionOn();
  mapper->LightingOn();
  mapper->DistanceOn();
  mapper->InteriorOn();
  Scene ours(mapper);
  vtkNew<vtkInkStippleActor> straight;
  straight->SetMapper(mapper);
  straight->VisibilityOff();
  ours.Renderer->AddActor(straight);
  start = drawing::ProcessorTime();
  ours.Draw();
  const double first = drawing::ProcessorTime() - start;

  vtkNew<vtkPolyDataMapper> plain;
  double size = 0.0;
  const auto points = PlainPoints(mapper, ours, stipples, size);
  plain->SetInputData(points);
  Scene theirs(plain);
  theirs.Renderer->GetActiveCamera()->DeepCopy(ours.Renderer->GetActiveCamera());
  BlendStraight(theirs.Renderer.Get());
  vtkProperty* property = theirs.Actor->GetProperty();
  property->LightingOff();
  property->SetColor(0.0, 0.0, 0.0);
  const double rimmed = 2.0 * ink::dotShape(static_cast<float>(size)).radius + 1.0;

  enum Side
  {
    Straight,
    ByPass,
    Plain,
    Blended,
    Sides
  };
  drawing::Frames times[Sides];
  double processed = 0.0;
  for (int frame = 0; frame < frames; ++frame)
  {
    for (const Side side : { Straight, ByPass, Plain, Blended })
    {
      Scene& window = side == Straight || side == ByPass ? ours : theirs;
      window.Turn(side == Straight || side == Plain ? 1.0 : 0.0);
      ours.Actor->SetVisibility(side == ByPass);
      straight->SetVisibility(side == Straight);
      property->SetPointSize(static_cast<float>(side == Blended ? rimmed : std::max(1.0, size)));
      property->SetOpacity(side == Blended ? 0.5 : 1.0);
      times[side].Measure([&] { window.Draw(); });
    }
    processed += static_cast<double>(mapper->GetNumberOfProcessedStipples()) / frames;
  }
  const auto processor = [&](Side side) { return drawing::Median(times[side].Processor); };
  const auto ratio = [&](Side side, Side to)
  { return points->GetNumberOfPoints() > 0 ? processor(side) / processor(to) : NAN; };
  std::printf("| %s | %s%lld | %.2f | %.2f | %.2f M | %.0f k | %.0f k | %.1f | %.1f | %.1f | %.2f | %.2f | "
              "%.2f | %.0f |\n",
    name.c_str(), isVolume ? "" : "polygons ",
    static_cast<long long>(isVolume ? data->GetNumberOfPoints() : data->GetNumberOfCells()), preprocessing,
    first, 1e-6 * static_cast<double>(stipples->GetNumberOfPoints()), 1e-3 * processed,
    1e-3 * static_cast<double>(points->GetNumberOfPoints()), size, 1e3 * processor(Straight),
    1.0 / drawing::Median(times[Straight].Wall), ratio(Straight, Plain), ratio(Straight, Blended),
    ratio(ByPass, Plain), drawing::PeakMemory());
  std::fflush(stdout);
}

} // namespace

int main(int argc, char* argv[])
{
  int frames = 15;
  bool large = false;
  std::vector<std::string> names;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument == "--frames" && i + 1 < argc)
    {
      frames = std::max(1, std::atoi(argv[++i]));
    }
    else if (argument == "--large")
    {
      large = true;
    }
    else if (argument.rfind("--", 0) != 0)
    {
      names.push_back(argument);
    }
  }
  using Source = std::function<vtkSmartPointer<vtkDataSet>()>;
  const auto volume = [](int x, int y, int z)
  { return Source([=] { return drawing::MakeVolume(x, y, z); }); };
  const auto mesh = [](int polygons) { return Source([=] { return MakeMesh(polygons); }); };
  const auto file = [](const char* name) { return Source([=] { return drawing::ReadVolume(name); }); };
  const struct
  {
    const char* Name;
    Source Make;
    int PerElement;
    bool Large;
  } cases[] = { { "iron-like", volume(64, 64, 64), 8, false },
    { "head-like", volume(256, 256, 113), 8, false }, { "engine", file("engine.nii.gz"), 8, false },
    { "leg-like", volume(341, 341, 93), 8, false }, { "lobster-like", volume(301, 324, 56), 8, false },
    { "foot-like", volume(256, 256, 256), 8, false }, { "bonsai", file("bonsai.nii.gz"), 8, false },
    { "horse-like", mesh(13352), 8, false }, { "low-res-dragon-like", mesh(45106), 8, false },
    { "bunny-like", mesh(69451), 8, false }, { "skeleton1-like", mesh(124018), 4, false },
    { "skeleton2-like", mesh(522567), 2, false }, { "hand-like", mesh(654666), 2, false },
    { "dragon-like", mesh(871414), 2, false }, { "50-million", file("bonsai.nii.gz"), 60, true } };
  std::printf("VTK %s; frame times by the median of %d, ms of processor time\n"
              "| data | voxels or polygons | preprocessing, s | first frame, s | stipples | processed | "
              "drawn | pixels | "
              "a frame, ms | frames a second | of plain points' time | of blended ones' | "
              "with vtkActor, of plain points' | "
              "peak memory, MiB |\n"
              "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n",
    vtkVersion::GetVTKVersion(), frames);
  for (const auto& one : cases)
  {
    const bool named = std::find(names.begin(), names.end(), one.Name) != names.end();
    if (named || (names.empty() && one.Large == large))
    {
      const vtkSmartPointer<vtkDataSet> data = one.Make();
      if (data->GetNumberOfPoints() == 0)
      {
        return EXIT_FAILURE;
      }
      Measure(one.Name, data, one.PerElement, frames);
    }
  }
  return EXIT_SUCCESS;
}
