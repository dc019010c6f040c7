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

#include "vtkInkStippleActor.h"
#include "vtkInkStippleControls.h"
#include "vtkInkStippleGenerator.h"
#include "vtkInkStippleMapper.h"

#include "Tone/DotCoverage.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVersion.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include <sys/resource.h>

namespace
{

vtkSmartPointer<vtkDataSet> ReadVolume(const char* name)
{
  vtkNew<vtkNIFTIImageReader> reader;
  reader->SetFileName((std::string(INK_DATA_DIR "/") + name).c_str());
  reader->Update();
  return reader->GetOutput();
}

/// Three shells, one in the other, of different densities, with noise.
vtkSmartPointer<vtkDataSet> MakeVolume(int x, int y, int z)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(x, y, z);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* values = vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars());
  unsigned int random = 1;
  vtkIdType n = 0;
  for (int k = 0; k < z; ++k)
  {
    for (int j = 0; j < y; ++j)
    {
      for (int i = 0; i < x; ++i, ++n)
      {
        const double r = 2.0 * std::hypot((i + 0.5) / x - 0.5, (j + 0.5) / y - 0.5, (k + 0.5) / z - 0.5);
        const double shells = r < 0.3 ? 220.0 : r < 0.6 ? 120.0 : r < 0.9 ? 60.0 : 0.0;
        random = random * 1664525u + 1013904223u;
        values->SetValue(n, static_cast<unsigned char>(shells + (random >> 28)));
      }
    }
  }
  return image;
}

vtkSmartPointer<vtkDataSet> MakeMesh(int polygons)
{
  vtkNew<vtkSphereSource> sphere;
  const int side = std::max(3, static_cast<int>(std::lround(std::sqrt(0.5 * polygons))));
  sphere->SetThetaResolution(side);
  sphere->SetPhiResolution(side);
  sphere->Update();
  return sphere->GetOutput();
}

double ProcessorTime()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double WallTime()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
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

struct Window
{
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Render;

  explicit Window(vtkMapper* mapper)
  {
    this->Actor->SetMapper(mapper);
    this->Renderer->AddActor(this->Actor);
    this->Renderer->SetBackground(1.0, 1.0, 1.0);
    this->Render->SetOffScreenRendering(true);
    this->Render->SetMultiSamples(0);
    this->Render->SetSize(1024, 768);
    this->Render->AddRenderer(this->Renderer);
    this->Renderer->ResetCamera();
    this->Renderer->GetActiveCamera()->Zoom(1.4);
  }
  void Draw()
  {
    this->Render->Render();
    this->Render->WaitForCompletion();
  }
};

/// As many of the stipples as the mapper draws now straight into the picture, as plain points, and the mean
/// diameter of their dots: dots that 8 bits cannot add up are drawn more rarely instead. None where there are
/// more stipples than vtkInkStippleMapper::FindMarks can look into.
vtkSmartPointer<vtkPolyData> PlainPoints(
  vtkInkStippleMapper* mapper, Window& window, vtkPolyData* stipples, double& size)
{
  vtkNew<vtkFloatArray> marks;
  auto points = vtkSmartPointer<vtkPolyData>::New();
  points->SetPoints(vtkNew<vtkPoints>());
  size = 0.0;
  if (!mapper->FindMarks(window.Renderer, window.Actor, marks))
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
  vtkNew<vtkIdList> ids;
  ids->SetNumberOfIds(count);
  std::iota(ids->begin(), ids->end(), 0);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell(ids);
  points->SetVerts(vertices);
  return points;
}

double Median(std::vector<double> times)
{
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
  return times[times.size() / 2];
}

void Measure(const std::string& name, vtkDataSet* data, int perElement, int frames)
{
  vtkNew<vtkInkStippleGenerator> generator;
  generator->SetMaximumStipples(perElement);
  generator->SetInputData(data);
  double start = ProcessorTime();
  generator->Update();
  const double preprocessing = ProcessorTime() - start;
  vtkPolyData* stipples = generator->GetOutput();
  const bool isVolume = vtkImageData::SafeDownCast(data) != nullptr;

  vtkNew<vtkInkStippleMapper> mapper;
  mapper->SetInputData(stipples);
  vtkNew<vtkInkStippleControls> controls;
  controls->SetPreset(isVolume ? "anatomy" : "engineering");
  controls->Apply(mapper);
  mapper->BoundaryOn();
  mapper->SilhouetteOn();
  mapper->ResolutionOn();
  mapper->LightingOn();
  mapper->DistanceOn();
  mapper->InteriorOn();
  Window ours(mapper);
  vtkNew<vtkInkStippleActor> straight;
  straight->SetMapper(mapper);
  straight->VisibilityOff();
  ours.Renderer->AddActor(straight);
  start = ProcessorTime();
  ours.Draw();
  const double first = ProcessorTime() - start;

  vtkNew<vtkPolyDataMapper> plain;
  double size = 0.0;
  const auto points = PlainPoints(mapper, ours, stipples, size);
  plain->SetInputData(points);
  Window theirs(plain);
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
  std::vector<double> wall[Sides];
  std::vector<double> processor[Sides];
  double processed = 0.0;
  for (int frame = 0; frame < frames; ++frame)
  {
    for (const Side side : { Straight, ByPass, Plain, Blended })
    {
      Window& window = side == Straight || side == ByPass ? ours : theirs;
      window.Renderer->GetActiveCamera()->Azimuth(side == Straight || side == Plain ? 1.0 : 0.0);
      window.Renderer->ResetCameraClippingRange();
      ours.Actor->SetVisibility(side == ByPass);
      straight->SetVisibility(side == Straight);
      property->SetPointSize(static_cast<float>(side == Blended ? rimmed : std::max(1.0, size)));
      property->SetOpacity(side == Blended ? 0.5 : 1.0);
      const double wallStart = WallTime();
      const double processorStart = ProcessorTime();
      window.Draw();
      wall[side].push_back(WallTime() - wallStart);
      processor[side].push_back(ProcessorTime() - processorStart);
    }
    processed += static_cast<double>(mapper->GetNumberOfProcessedStipples()) / frames;
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto ratio = [&](Side side, Side to)
  { return points->GetNumberOfPoints() > 0 ? Median(processor[side]) / Median(processor[to]) : NAN; };
  std::printf("| %s | %s%lld | %.2f | %.2f | %.2f M | %.0f k | %.0f k | %.1f | %.1f | %.1f | %.2f | %.2f | "
              "%.2f | %.0f |\n",
    name.c_str(), isVolume ? "" : "polygons ",
    static_cast<long long>(isVolume ? data->GetNumberOfPoints() : data->GetNumberOfCells()), preprocessing,
    first, 1e-6 * static_cast<double>(stipples->GetNumberOfPoints()), 1e-3 * processed,
    1e-3 * static_cast<double>(points->GetNumberOfPoints()), size, 1e3 * Median(processor[Straight]),
    1.0 / Median(wall[Straight]), ratio(Straight, Plain), ratio(Straight, Blended), ratio(ByPass, Plain),
    static_cast<double>(usage.ru_maxrss) / 1024.0);
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
  const auto volume = [](int x, int y, int z) { return Source([=] { return MakeVolume(x, y, z); }); };
  const auto mesh = [](int polygons) { return Source([=] { return MakeMesh(polygons); }); };
  const auto file = [](const char* name) { return Source([=] { return ReadVolume(name); }); };
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
              "| data | voxels or polygons | preprocessing, s | first frame, s | stipples | looked at | "
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
