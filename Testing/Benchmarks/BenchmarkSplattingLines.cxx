// SPDX-License-Identifier: BSD-3-Clause
/// One frame of vtkInkSplattingLinesMapper against VTK's own ways of drawing the same points in the same
/// window: the iso-surface 40 of Data/bonsai.nii.gz, 1024 x 768 pixels, splats of one voxel's radius. The
/// camera moves by a degree each frame unless the benchmark's name says otherwise.
#include "vtkInkSplattingLinesMapper.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkIdList.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <benchmark/benchmark.h>

#include <numeric>

namespace
{

constexpr double Radius = 1.0;

vtkPolyData* Points()
{
  static const vtkSmartPointer<vtkPolyData> points = []
  {
    vtkNew<vtkNIFTIImageReader> reader;
    reader->SetFileName(INK_DATA_DIR "/bonsai.nii.gz");
    vtkNew<vtkFlyingEdges3D> surface;
    surface->SetInputConnection(reader->GetOutputPort());
    surface->SetValue(0, 40.0);
    surface->ComputeScalarsOff();
    surface->Update();
    vtkPolyData* polyData = surface->GetOutput();
    vtkNew<vtkIdList> ids;
    ids->SetNumberOfIds(polyData->GetNumberOfPoints());
    std::iota(ids->begin(), ids->end(), 0);
    vtkNew<vtkCellArray> vertices;
    vertices->InsertNextCell(ids);
    polyData->SetPolys(nullptr);
    polyData->SetVerts(vertices);
    return vtkSmartPointer<vtkPolyData>(polyData);
  }();
  return points;
}

/// The window, with one actor of a mapper's.
class Scene
{
public:
  explicit Scene(vtkMapper* mapper)
  {
    this->Actor->SetMapper(mapper);
    this->Renderer->AddActor(this->Actor);
    this->Window->SetOffScreenRendering(true);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(1024, 768);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->ResetCamera();
    this->Renderer->GetActiveCamera()->Zoom(1.6);
    this->Draw();
  }

  vtkProperty* GetProperty() { return this->Actor->GetProperty(); }
  void Turn() { this->Renderer->GetActiveCamera()->Azimuth(1.0); }
  void Draw()
  {
    this->Window->Render();
    this->Window->WaitForCompletion();
  }
  void Report(benchmark::State& state)
  {
    state.counters["points"] = static_cast<double>(Points()->GetNumberOfPoints());
  }

private:
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

vtkSmartPointer<vtkInkSplattingLinesMapper> SplattingLines()
{
  auto mapper = vtkSmartPointer<vtkInkSplattingLinesMapper>::New();
  mapper->SetInputData(Points());
  mapper->SetRadius(Radius);
  return mapper;
}

void SplattingLinesOfLambda(benchmark::State& state)
{
  auto mapper = SplattingLines();
  mapper->SetLambda(static_cast<double>(state.range(0)));
  Scene scene(mapper);
  for (auto _ : state)
  {
    scene.Turn();
    scene.Draw();
  }
  scene.Report(state);
}
BENCHMARK(SplattingLinesOfLambda)
  ->Arg(1)
  ->Arg(2)
  ->Arg(3)
  ->Arg(6)
  ->Unit(benchmark::kMillisecond)
  ->MeasureProcessCPUTime()
  ->UseRealTime();

void SplattingLinesFrontFacesOnly(benchmark::State& state)
{
  auto mapper = SplattingLines();
  mapper->SetLambda(2.0);
  Scene scene(mapper);
  scene.GetProperty()->BackfaceCullingOn();
  for (auto _ : state)
  {
    scene.Turn();
    scene.Draw();
  }
  scene.Report(state);
}
BENCHMARK(SplattingLinesFrontFacesOnly)
  ->Unit(benchmark::kMillisecond)
  ->MeasureProcessCPUTime()
  ->UseRealTime();

void SplattingLinesUnchangedView(benchmark::State& state)
{
  Scene scene(SplattingLines());
  for (auto _ : state)
  {
    scene.Draw();
  }
  scene.Report(state);
}
BENCHMARK(SplattingLinesUnchangedView)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void SplattingLinesChangedTau(benchmark::State& state)
{
  auto mapper = SplattingLines();
  Scene scene(mapper);
  for (auto _ : state)
  {
    mapper->SetTau(mapper->GetTau() == 1.0 ? 0.99 : 1.0);
    scene.Draw();
  }
  scene.Report(state);
}
BENCHMARK(SplattingLinesChangedTau)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void PointGaussianDiscs(benchmark::State& state)
{
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(Points());
  mapper->SetScaleFactor(Radius);
  mapper->EmissiveOff();
  mapper->SetSplatShaderCode("//VTK::Color::Impl\n"
                             "if (dot(offsetVCVSOutput.xy, offsetVCVSOutput.xy) > 1.0)\n"
                             "{\n"
                             "  discard;\n"
                             "}\n");
  Scene scene(mapper);
  for (auto _ : state)
  {
    scene.Turn();
    scene.Draw();
  }
  scene.Report(state);
}
BENCHMARK(PointGaussianDiscs)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void PlainPointsOfPixels(benchmark::State& state)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(Points());
  Scene scene(mapper);
  scene.GetProperty()->SetPointSize(static_cast<float>(state.range(0)));
  for (auto _ : state)
  {
    scene.Turn();
    scene.Draw();
  }
  scene.Report(state);
}
BENCHMARK(PlainPointsOfPixels)
  ->Arg(1)
  ->Arg(5)
  ->Arg(9)
  ->Unit(benchmark::kMillisecond)
  ->MeasureProcessCPUTime()
  ->UseRealTime();

} // namespace

BENCHMARK_MAIN();
