// SPDX-License-Identifier: BSD-3-Clause
// What stippling a volume of 256^3 voxels takes before the first picture: vtkInkStippleGenerator on bonsai,
// by the number of threads. Both wall-clock and CPU time are reported. For comparison vtkFlyingEdges3D with
// normals, what a surface of the same volume takes.

#include "BenchmarkArguments.h"
#include "vtkInkStippleGenerator.h"

#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkVersion.h"

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <string>

namespace
{

template <class Filter>
void Run(benchmark::State& state, vtkImageData* image, int threads, Filter* filter)
{
  setenv("VTK_SMP_MAX_THREADS", std::to_string(threads).c_str(), 1);
  vtkSMPTools::Initialize(threads);
  filter->SetInputData(image);
  for ([[maybe_unused]] auto iteration : state)
  {
    filter->Modified();
    filter->Update();
  }
  state.counters["points"] = static_cast<double>(filter->GetOutput()->GetNumberOfPoints());
}

} // namespace

int main(int argc, char* argv[])
{
  if (!InitializeBenchmarks(argc, argv, 5))
  {
    return EXIT_FAILURE;
  }
  vtkNew<vtkNIFTIImageReader> reader;
  reader->SetFileName(INK_DATA_DIR "/bonsai.nii.gz");
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  if (image->GetNumberOfPoints() == 0)
  {
    return EXIT_FAILURE;
  }
  vtkNew<vtkInkStippleGenerator> generator;
  vtkNew<vtkFlyingEdges3D> surface;
  surface->SetValue(0, 40.0);
  surface->ComputeScalarsOff();
  for (const int threads : { 1, 2 })
  {
    const std::string name = "bonsai/threads:" + std::to_string(threads) + "/";
    const auto add = [&](const char* filter, auto run)
    {
      benchmark::RegisterBenchmark((name + filter).c_str(), run)
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime()
        ->UseRealTime();
    };
    add("vtkInkStippleGenerator",
      [=, &generator](benchmark::State& state) { Run(state, image, threads, generator.Get()); });
    add("vtkFlyingEdges3D",
      [=, &surface](benchmark::State& state) { Run(state, image, threads, surface.Get()); });
  }
  benchmark::AddCustomContext("VTK", vtkVersion::GetVTKVersion());
  benchmark::RunSpecifiedBenchmarks();
  return EXIT_SUCCESS;
}
